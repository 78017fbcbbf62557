// SPDX-License-Identifier: BSD-3-Clause
/// The library compiles after headers that define common words as macros, and leaves the macros as they are. Each
/// stands here for what no compiler takes; a line that is missing in hide_macros.hpp stops this file.

// windows.h, and the headers that it includes
#undef far
#define far @a macro of a system
#undef near
#define near @a macro of a system
#undef huge
#define huge @a macro of a system
#undef pascal
#define pascal @a macro of a system
#undef cdecl
#define cdecl @a macro of a system
#undef small
#define small @a macro of a system
#undef hyper
#define hyper @a macro of a system
#undef min
#define min(a, b) (((a) < (b)) ? (a) : (b))
#undef max
#define max(a, b) (((a) > (b)) ? (a) : (b))
#undef interface
#define interface @a macro of a system
#undef IN
#define IN @a macro of a system
#undef OUT
#define OUT @a macro of a system
#undef OPTIONAL
#define OPTIONAL @a macro of a system
#undef ERROR
#define ERROR @a macro of a system
#undef DELETE
#define DELETE @a macro of a system
#undef CONST
#define CONST @a macro of a system
#undef VOID
#define VOID @a macro of a system
#undef ABSOLUTE
#define ABSOLUTE @a macro of a system
#undef RELATIVE
#define RELATIVE @a macro of a system
#undef TRANSPARENT
#define TRANSPARENT @a macro of a system
#undef OPAQUE
#define OPAQUE @a macro of a system
#undef DIFFERENCE
#define DIFFERENCE @a macro of a system
#undef STRICT
#define STRICT @a macro of a system
#undef THIS
#define THIS @a macro of a system
#undef NO_ERROR
#define NO_ERROR @a macro of a system
#undef ALTERNATE
#define ALTERNATE @a macro of a system
#undef WINDING
#define WINDING @a macro of a system
#undef PASSTHROUGH
#define PASSTHROUGH @a macro of a system
#undef GetObject
#define GetObject @a macro of a system
#undef GetMessage
#define GetMessage @a macro of a system
#undef SendMessage
#define SendMessage @a macro of a system
#undef CreateWindow
#define CreateWindow @a macro of a system
#undef DrawText
#define DrawText @a macro of a system
#undef LoadImage
#define LoadImage @a macro of a system
// X11/X.h, X11/Xlib.h
#undef None
#define None @a macro of a system
#undef Status
#define Status @a macro of a system
#undef Success
#define Success @a macro of a system
#undef Bool
#define Bool @a macro of a system
#undef True
#define True @a macro of a system
#undef False
#define False @a macro of a system
#undef Always
#define Always @a macro of a system
#undef Never
#define Never @a macro of a system
#undef Above
#define Above @a macro of a system
#undef Below
#define Below @a macro of a system
#undef Complex
#define Complex @a macro of a system
#undef Convex
#define Convex @a macro of a system
#undef Unsorted
#define Unsorted @a macro of a system
#undef Nonconvex
#define Nonconvex @a macro of a system
#undef CursorShape
#define CursorShape @a macro of a system
#undef KeyPress
#define KeyPress @a macro of a system
#undef KeyRelease
#define KeyRelease @a macro of a system
#undef FocusIn
#define FocusIn @a macro of a system
#undef FocusOut
#define FocusOut @a macro of a system
#undef Expose
#define Expose @a macro of a system
#undef Window
#define Window @a macro of a system
#undef Screen
#define Screen @a macro of a system
#undef Font
#define Font @a macro of a system
#undef Pixmap
#define Pixmap @a macro of a system
#undef Display
#define Display @a macro of a system
#undef Colormap
#define Colormap @a macro of a system
#undef GrayScale
#define GrayScale @a macro of a system
#undef StaticGray
#define StaticGray @a macro of a system
#undef TrueColor
#define TrueColor @a macro of a system
// sys/param.h, sys/sysmacros.h, math.h and complex.h of several systems
#undef MIN
#define MIN @a macro of a system
#undef MAX
#define MAX @a macro of a system
#undef howmany
#define howmany @a macro of a system
#undef roundup
#define roundup @a macro of a system
#undef powerof2
#define powerof2 @a macro of a system
#undef isset
#define isset @a macro of a system
#undef setbit
#define setbit @a macro of a system
#undef clrbit
#define clrbit @a macro of a system
#undef major
#define major @a macro of a system
#undef minor
#define minor @a macro of a system
#undef makedev
#define makedev @a macro of a system
#undef I
#define I @a macro of a system
#undef complex
#define complex @a macro of a system
#undef imaginary
#define imaginary @a macro of a system
#undef DOMAIN
#define DOMAIN @a macro of a system
#undef SING
#define SING @a macro of a system
#undef OVERFLOW
#define OVERFLOW @a macro of a system
#undef UNDERFLOW
#define UNDERFLOW @a macro of a system
#undef PLOSS
#define PLOSS @a macro of a system
#undef TLOSS
#define TLOSS @a macro of a system
#undef HUGE
#define HUGE @a macro of a system
// compilers that name the system
#undef linux
#define linux @a macro of a system
#undef unix
#define unix @a macro of a system
#undef i386
#define i386 @a macro of a system
#undef mips
#define mips @a macro of a system
#undef sparc
#define sparc @a macro of a system
#undef sun
#define sun @a macro of a system
// AssertMacros.h and objc.h of macOS
#undef check
#define check @a macro of a system
#undef verify
#define verify @a macro of a system
#undef require
#define require @a macro of a system
#undef nil
#define nil @a macro of a system
#undef Nil
#define Nil @a macro of a system
#undef YES
#define YES @a macro of a system
#undef NO
#define NO @a macro of a system
// Qt, Arduino
#undef signals
#define signals @a macro of a system
#undef slots
#define slots @a macro of a system
#undef emit
#define emit @a macro of a system
#undef foreach
#define foreach @a macro of a system
#undef forever
#define forever @a macro of a system
#undef PI
#define PI @a macro of a system
#undef HALF_PI
#define HALF_PI @a macro of a system
#undef TWO_PI
#define TWO_PI @a macro of a system
#undef DEG_TO_RAD
#define DEG_TO_RAD @a macro of a system
#undef RAD_TO_DEG
#define RAD_TO_DEG @a macro of a system
#undef abs
#define abs(x) ((x) > 0 ? (x) : -(x))
#undef round
#define round(x) ((long)((x) + 0.5))
#undef sq
#define sq(x) ((x) * (x))
#undef radians
#define radians(deg) ((deg) * 0.017)
#undef degrees
#define degrees(rad) ((rad) * 57.3)
#undef bit
#define bit @a macro of a system
#undef constrain
#define constrain @a macro of a system
#undef B0
#define B0 @a macro of a system
#undef B1
#define B1 @a macro of a system

#include <vcavity/vcavity.hpp>

#if !defined(far)
#error "far is gone"
#endif
#undef far
#if !defined(near)
#error "near is gone"
#endif
#undef near
#if !defined(huge)
#error "huge is gone"
#endif
#undef huge
#if !defined(pascal)
#error "pascal is gone"
#endif
#undef pascal
#if !defined(cdecl)
#error "cdecl is gone"
#endif
#undef cdecl
#if !defined(small)
#error "small is gone"
#endif
#undef small
#if !defined(hyper)
#error "hyper is gone"
#endif
#undef hyper
#if !defined(min)
#error "min is gone"
#endif
#undef min
#if !defined(max)
#error "max is gone"
#endif
#undef max
#if !defined(interface)
#error "interface is gone"
#endif
#undef interface
#if !defined(IN)
#error "IN is gone"
#endif
#undef IN
#if !defined(OUT)
#error "OUT is gone"
#endif
#undef OUT
#if !defined(OPTIONAL)
#error "OPTIONAL is gone"
#endif
#undef OPTIONAL
#if !defined(ERROR)
#error "ERROR is gone"
#endif
#undef ERROR
#if !defined(DELETE)
#error "DELETE is gone"
#endif
#undef DELETE
#if !defined(CONST)
#error "CONST is gone"
#endif
#undef CONST
#if !defined(VOID)
#error "VOID is gone"
#endif
#undef VOID
#if !defined(ABSOLUTE)
#error "ABSOLUTE is gone"
#endif
#undef ABSOLUTE
#if !defined(RELATIVE)
#error "RELATIVE is gone"
#endif
#undef RELATIVE
#if !defined(TRANSPARENT)
#error "TRANSPARENT is gone"
#endif
#undef TRANSPARENT
#if !defined(OPAQUE)
#error "OPAQUE is gone"
#endif
#undef OPAQUE
#if !defined(DIFFERENCE)
#error "DIFFERENCE is gone"
#endif
#undef DIFFERENCE
#if !defined(STRICT)
#error "STRICT is gone"
#endif
#undef STRICT
#if !defined(THIS)
#error "THIS is gone"
#endif
#undef THIS
#if !defined(NO_ERROR)
#error "NO_ERROR is gone"
#endif
#undef NO_ERROR
#if !defined(ALTERNATE)
#error "ALTERNATE is gone"
#endif
#undef ALTERNATE
#if !defined(WINDING)
#error "WINDING is gone"
#endif
#undef WINDING
#if !defined(PASSTHROUGH)
#error "PASSTHROUGH is gone"
#endif
#undef PASSTHROUGH
#if !defined(GetObject)
#error "GetObject is gone"
#endif
#undef GetObject
#if !defined(GetMessage)
#error "GetMessage is gone"
#endif
#undef GetMessage
#if !defined(SendMessage)
#error "SendMessage is gone"
#endif
#undef SendMessage
#if !defined(CreateWindow)
#error "CreateWindow is gone"
#endif
#undef CreateWindow
#if !defined(DrawText)
#error "DrawText is gone"
#endif
#undef DrawText
#if !defined(LoadImage)
#error "LoadImage is gone"
#endif
#undef LoadImage
#if !defined(None)
#error "None is gone"
#endif
#undef None
#if !defined(Status)
#error "Status is gone"
#endif
#undef Status
#if !defined(Success)
#error "Success is gone"
#endif
#undef Success
#if !defined(Bool)
#error "Bool is gone"
#endif
#undef Bool
#if !defined(True)
#error "True is gone"
#endif
#undef True
#if !defined(False)
#error "False is gone"
#endif
#undef False
#if !defined(Always)
#error "Always is gone"
#endif
#undef Always
#if !defined(Never)
#error "Never is gone"
#endif
#undef Never
#if !defined(Above)
#error "Above is gone"
#endif
#undef Above
#if !defined(Below)
#error "Below is gone"
#endif
#undef Below
#if !defined(Complex)
#error "Complex is gone"
#endif
#undef Complex
#if !defined(Convex)
#error "Convex is gone"
#endif
#undef Convex
#if !defined(Unsorted)
#error "Unsorted is gone"
#endif
#undef Unsorted
#if !defined(Nonconvex)
#error "Nonconvex is gone"
#endif
#undef Nonconvex
#if !defined(CursorShape)
#error "CursorShape is gone"
#endif
#undef CursorShape
#if !defined(KeyPress)
#error "KeyPress is gone"
#endif
#undef KeyPress
#if !defined(KeyRelease)
#error "KeyRelease is gone"
#endif
#undef KeyRelease
#if !defined(FocusIn)
#error "FocusIn is gone"
#endif
#undef FocusIn
#if !defined(FocusOut)
#error "FocusOut is gone"
#endif
#undef FocusOut
#if !defined(Expose)
#error "Expose is gone"
#endif
#undef Expose
#if !defined(Window)
#error "Window is gone"
#endif
#undef Window
#if !defined(Screen)
#error "Screen is gone"
#endif
#undef Screen
#if !defined(Font)
#error "Font is gone"
#endif
#undef Font
#if !defined(Pixmap)
#error "Pixmap is gone"
#endif
#undef Pixmap
#if !defined(Display)
#error "Display is gone"
#endif
#undef Display
#if !defined(Colormap)
#error "Colormap is gone"
#endif
#undef Colormap
#if !defined(GrayScale)
#error "GrayScale is gone"
#endif
#undef GrayScale
#if !defined(StaticGray)
#error "StaticGray is gone"
#endif
#undef StaticGray
#if !defined(TrueColor)
#error "TrueColor is gone"
#endif
#undef TrueColor
#if !defined(MIN)
#error "MIN is gone"
#endif
#undef MIN
#if !defined(MAX)
#error "MAX is gone"
#endif
#undef MAX
#if !defined(howmany)
#error "howmany is gone"
#endif
#undef howmany
#if !defined(roundup)
#error "roundup is gone"
#endif
#undef roundup
#if !defined(powerof2)
#error "powerof2 is gone"
#endif
#undef powerof2
#if !defined(isset)
#error "isset is gone"
#endif
#undef isset
#if !defined(setbit)
#error "setbit is gone"
#endif
#undef setbit
#if !defined(clrbit)
#error "clrbit is gone"
#endif
#undef clrbit
#if !defined(major)
#error "major is gone"
#endif
#undef major
#if !defined(minor)
#error "minor is gone"
#endif
#undef minor
#if !defined(makedev)
#error "makedev is gone"
#endif
#undef makedev
#if !defined(I)
#error "I is gone"
#endif
#undef I
#if !defined(complex)
#error "complex is gone"
#endif
#undef complex
#if !defined(imaginary)
#error "imaginary is gone"
#endif
#undef imaginary
#if !defined(DOMAIN)
#error "DOMAIN is gone"
#endif
#undef DOMAIN
#if !defined(SING)
#error "SING is gone"
#endif
#undef SING
#if !defined(OVERFLOW)
#error "OVERFLOW is gone"
#endif
#undef OVERFLOW
#if !defined(UNDERFLOW)
#error "UNDERFLOW is gone"
#endif
#undef UNDERFLOW
#if !defined(PLOSS)
#error "PLOSS is gone"
#endif
#undef PLOSS
#if !defined(TLOSS)
#error "TLOSS is gone"
#endif
#undef TLOSS
#if !defined(HUGE)
#error "HUGE is gone"
#endif
#undef HUGE
#if !defined(linux)
#error "linux is gone"
#endif
#undef linux
#if !defined(unix)
#error "unix is gone"
#endif
#undef unix
#if !defined(i386)
#error "i386 is gone"
#endif
#undef i386
#if !defined(mips)
#error "mips is gone"
#endif
#undef mips
#if !defined(sparc)
#error "sparc is gone"
#endif
#undef sparc
#if !defined(sun)
#error "sun is gone"
#endif
#undef sun
#if !defined(check)
#error "check is gone"
#endif
#undef check
#if !defined(verify)
#error "verify is gone"
#endif
#undef verify
#if !defined(require)
#error "require is gone"
#endif
#undef require
#if !defined(nil)
#error "nil is gone"
#endif
#undef nil
#if !defined(Nil)
#error "Nil is gone"
#endif
#undef Nil
#if !defined(YES)
#error "YES is gone"
#endif
#undef YES
#if !defined(NO)
#error "NO is gone"
#endif
#undef NO
#if !defined(signals)
#error "signals is gone"
#endif
#undef signals
#if !defined(slots)
#error "slots is gone"
#endif
#undef slots
#if !defined(emit)
#error "emit is gone"
#endif
#undef emit
#if !defined(foreach)
#error "foreach is gone"
#endif
#undef foreach
#if !defined(forever)
#error "forever is gone"
#endif
#undef forever
#if !defined(PI)
#error "PI is gone"
#endif
#undef PI
#if !defined(HALF_PI)
#error "HALF_PI is gone"
#endif
#undef HALF_PI
#if !defined(TWO_PI)
#error "TWO_PI is gone"
#endif
#undef TWO_PI
#if !defined(DEG_TO_RAD)
#error "DEG_TO_RAD is gone"
#endif
#undef DEG_TO_RAD
#if !defined(RAD_TO_DEG)
#error "RAD_TO_DEG is gone"
#endif
#undef RAD_TO_DEG
#if !defined(abs)
#error "abs is gone"
#endif
#undef abs
#if !defined(round)
#error "round is gone"
#endif
#undef round
#if !defined(sq)
#error "sq is gone"
#endif
#undef sq
#if !defined(radians)
#error "radians is gone"
#endif
#undef radians
#if !defined(degrees)
#error "degrees is gone"
#endif
#undef degrees
#if !defined(bit)
#error "bit is gone"
#endif
#undef bit
#if !defined(constrain)
#error "constrain is gone"
#endif
#undef constrain
#if !defined(B0)
#error "B0 is gone"
#endif
#undef B0
#if !defined(B1)
#error "B1 is gone"
#endif
#undef B1

#include "support/catch.hpp"

TEST_CASE("after the macros of system headers the library is what it was") {
  const vcavity::Cavity<double> groove(vcavity::radians(180.0));
  const vcavity::Conductor<double> silver(0.1249, 3.3391);
  CHECK(vcavity::directional_reflectance(groove, vcavity::direction(0.0, 0.0), silver) ==
        Approx(silver(1.0)));
}
