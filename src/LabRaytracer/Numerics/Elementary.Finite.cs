using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <content>Points of any size.</content>
internal static partial class Elementary
{
    /// <summary>The number; 0 for NaN, the largest finite number with its sign for an infinite one.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static T Finite<T>(T a)
        where T : unmanaged, IReal<T>
    {
        T most = T.Of(T.IsSingle ? float.MaxValue : double.MaxValue);
        return T.Max(T.Min(T.Select(T.Equal(a, a), a, T.Zero), most), -most);
    }

    /// <summary>Divides a point by its largest coordinate, so that squares neither overflow nor vanish; returns that coordinate, 1 at the origin.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static T ToUnitBox<T>(ref T x, ref T y, ref T z)
        where T : unmanaged, IReal<T>
    {
        (x, y, z) = (Finite(x), Finite(y), Finite(z));
        T size = T.Max(T.Max(T.Abs(x), T.Abs(y)), T.Abs(z));
        size = T.Select(T.Less(T.Zero, size), size, T.Of(1));
        (x, y, z) = (x / size, y / size, z / size);
        return size;
    }

    /// <summary>1 / size: what gradients of a point divided by its size are multiplied with; 0 for sizes so small that it would not be finite, which count as the origin.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static T GradientScale<T>(T size)
        where T : unmanaged, IReal<T> => T.Select(T.Less(size, T.Of(T.IsSingle ? 1e-30 : 1e-300)), T.Zero, T.Of(1) / size);
}
