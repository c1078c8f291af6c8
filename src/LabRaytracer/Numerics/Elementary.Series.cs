using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <content>Minimax polynomials: the output of tests/LabRaytracer.Tests/Oracle/coefficients.py.</content>
internal static partial class Elementary
{
    /// <summary>(atan(sqrt s) / (2 pi sqrt s) - 1 / 2 pi) / s on [0, tan² pi/8]; float lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static T AtanTailSingle<T>(T s)
        where T : unmanaged, IReal<T>
    {
        T s2 = s * s;
        T even = T.Fma(T.Of(-0.009673409163951874), s2, T.Of(-0.022669268772006035));
        even = T.Fma(even, s2, T.Of(-0.05305161699652672));
        T odd = T.Fma(T.Of(0.016860434785485268), s2, T.Of(0.03182855620980263));
        return T.Fma(odd, s, even);
    }

    /// <summary>(atan(sqrt s) / (2 pi sqrt s) - 1 / 2 pi) / s on [0, tan² pi/8]; double lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static T AtanTailDouble<T>(T s)
        where T : unmanaged, IReal<T>
    {
        T s2 = s * s;
        T even = T.Fma(T.Of(-0.00284943750816623), s2, T.Of(-0.008020038465714181));
        even = T.Fma(even, s2, T.Of(-0.010604649356410235));
        even = T.Fma(even, s2, T.Of(-0.014468613090040723));
        even = T.Fma(even, s2, T.Of(-0.02273642043286274));
        even = T.Fma(even, s2, T.Of(-0.053051647697298226));
        T odd = T.Fma(T.Of(0.006057564491080749), s2, T.Of(0.009307139268913885));
        odd = T.Fma(odd, s2, T.Of(0.012242293061496124));
        odd = T.Fma(odd, s2, T.Of(0.017683882041843634));
        odd = T.Fma(odd, s2, T.Of(0.03183098861830459));
        return T.Fma(odd, s, even);
    }

    /// <summary>(sin(2 pi sqrt s) / sqrt s - 2 pi) / s on [0, 1/64]; float lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static T SinTailSingle<T>(T s)
        where T : unmanaged, IReal<T>
    {
        T s2 = s * s;
        T even = T.Fma(T.Of(-75.44548034667969), s2, T.Of(-41.341670989990234));
        T odd = T.Of(81.59376525878906);
        return T.Fma(odd, s, even);
    }

    /// <summary>(sin(2 pi sqrt s) / sqrt s - 2 pi) / s on [0, 1/64]; double lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static T SinTailDouble<T>(T s)
        where T : unmanaged, IReal<T>
    {
        T s2 = s * s;
        T even = T.Fma(T.Of(-15.09382260591026), s2, T.Of(-76.70585970788872));
        even = T.Fma(even, s2, T.Of(-41.34170224039967));
        T odd = T.Fma(T.Of(3.781220543492817), s2, T.Of(42.058685391646385));
        odd = T.Fma(odd, s2, T.Of(81.60524927596518));
        return T.Fma(odd, s, even);
    }

    /// <summary>((cos(2 pi sqrt s) - 1) / s + 2 pi²) / s on [0, 1/64]; float lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static T CosTailSingle<T>(T s)
        where T : unmanaged, IReal<T>
    {
        T s2 = s * s;
        T even = T.Fma(T.Of(59.45417022705078), s2, T.Of(64.93937683105469));
        T odd = T.Of(-85.44964599609375);
        return T.Fma(odd, s, even);
    }

    /// <summary>((cos(2 pi sqrt s) - 1) / s + 2 pi²) / s on [0, 1/64]; double lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static T CosTailDouble<T>(T s)
        where T : unmanaged, IReal<T>
    {
        T s2 = s * s;
        T even = T.Fma(T.Of(7.90321544259473), s2, T.Of(60.244641354297215));
        even = T.Fma(even, s2, T.Of(64.93939402266825));
        T odd = T.Fma(T.Of(-1.699200740026335), s2, T.Of(-26.426253444227033));
        odd = T.Fma(odd, s2, T.Of(-85.45681720665114));
        return T.Fma(odd, s, even);
    }
}
