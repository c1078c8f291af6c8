using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <content>Minimax polynomials: the output of tests/LabRaytracer.Tests/Oracle/coefficients.py.</content>
internal static partial class Elementary
{
    /// <summary>(2 atanh(sqrt s) / (ln 2 sqrt s) - 2 / ln 2) / s on [0, 0.0295]; float lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static T Log2TailSingle<T>(T s)
        where T : unmanaged, IReal<T>
    {
        T s2 = s * s;
        T even = T.Fma(T.Of(0.4117067754268646), s2, T.Of(0.9617967009544373));
        T odd = T.Fma(T.Of(0.34021082520484924), s2, T.Of(0.5770828723907471));
        return T.Fma(odd, s, even);
    }

    /// <summary>(2 atanh(sqrt s) / (ln 2 sqrt s) - 2 / ln 2) / s on [0, 0.0295]; double lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static T Log2TailDouble<T>(T s)
        where T : unmanaged, IReal<T>
    {
        T s2 = s * s;
        T even = T.Fma(T.Of(0.17361346306365272), s2, T.Of(0.19240748290033616));
        even = T.Fma(even, s2, T.Of(0.262308202082112));
        even = T.Fma(even, s2, T.Of(0.41219858311156404));
        even = T.Fma(even, s2, T.Of(0.9617966939259756));
        T odd = T.Fma(T.Of(0.16834321846222194), s2, T.Of(0.22195208055603363));
        odd = T.Fma(odd, s2, T.Of(0.3205988978763326));
        odd = T.Fma(odd, s2, T.Of(0.5770780163555844));
        return T.Fma(odd, s, even);
    }

    /// <summary>((2^r - 1) / r - ln 2) / r on [-1/2, 1/2]; float lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static T Exp2TailSingle<T>(T r)
        where T : unmanaged, IReal<T>
    {
        T r2 = r * r;
        T even = T.Fma(T.Of(0.00015417279792018235), r2, T.Of(0.00961817242205143));
        even = T.Fma(even, r2, T.Of(0.24022650718688965));
        T odd = T.Fma(T.Of(0.001338126021437347), r2, T.Of(0.055503811687231064));
        return T.Fma(odd, r, even);
    }

    /// <summary>((2^r - 1) / r - ln 2) / r on [-1/2, 1/2]; double lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static T Exp2TailDouble<T>(T r)
        where T : unmanaged, IReal<T>
    {
        T r2 = r * r;
        T even = T.Fma(T.Of(2.56939498221337e-11), r2, T.Of(7.0549194109372775e-09));
        even = T.Fma(even, r2, T.Of(1.3215486760355846e-06));
        even = T.Fma(even, r2, T.Of(0.0001540353039341389));
        even = T.Fma(even, r2, T.Of(0.009618129107628466));
        even = T.Fma(even, r2, T.Of(0.24022650695910072));
        T odd = T.Fma(T.Of(4.4549567059414554e-10), r2, T.Of(1.0178062468891632e-07));
        odd = T.Fma(odd, r2, T.Of(1.5252733829790772e-05));
        odd = T.Fma(odd, r2, T.Of(0.0013333558146416968));
        odd = T.Fma(odd, r2, T.Of(0.0555041086648216));
        return T.Fma(odd, r, even);
    }
}
