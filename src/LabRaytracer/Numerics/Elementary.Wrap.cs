using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <content>Texture coordinates outside [0, 1].</content>
internal static partial class Elementary
{
    /// <summary>The repeated picture: u - floor(u), [0, 1), exact except that what would round up to 1 becomes 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static T WrapRepeat<T>(T u)
        where T : unmanaged, IReal<T>
    {
        T fraction = u - T.Floor(u);
        return T.Select(T.Less(fraction, T.Of(1)), fraction, T.Zero);
    }

    /// <summary>The repeated picture, every second one mirrored: [0, 1].</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static T WrapMirror<T>(T u)
        where T : unmanaged, IReal<T>
    {
        T pair = T.Abs(u) - (T.Of(2) * T.Floor(T.Abs(u) * T.Of(0.5)));
        return T.Min(pair, T.Of(2) - pair);
    }

    /// <summary>The edge goes on: [0, 1].</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static T WrapClamp<T>(T u)
        where T : unmanaged, IReal<T> => T.Min(T.Max(u, T.Zero), T.Of(1));
}
