using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LabRaytracer;

/// <summary>Three columns of floats, written as triples one after the other, or made of rows.</summary>
internal static unsafe class LaneTriples
{
    /// <summary>Rows of four numbers become columns.</summary>
    /// <param name="rows">As many rows as lanes, and at least four.</param>
    /// <param name="x">The first numbers.</param>
    /// <param name="y">The second numbers.</param>
    /// <param name="z">The third numbers.</param>
    /// <param name="w">The fourth numbers.</param>
    public static void Turn<F>(Float4* rows, out F x, out F y, out F z, out F w)
        where F : unmanaged, IReal<F>
    {
        Turn(rows, out x, out y, out z);
        F weights = default;
        float* to = (float*)&weights;
        for (int lane = 0; lane < F.Width; lane++)
        {
            to[lane] = ((float*)(rows + lane))[3];
        }

        w = weights;
    }

    /// <summary>Rows of four numbers become columns of their first three.</summary>
    /// <param name="rows">As many rows as lanes, and at least four.</param>
    /// <param name="x">The first numbers.</param>
    /// <param name="y">The second numbers.</param>
    /// <param name="z">The third numbers.</param>
    [SkipLocalsInit]
    public static void Turn<F>(Float4* rows, out F x, out F y, out F z)
        where F : unmanaged, IReal<F>
    {
        // Joined in registers where the width is known: a load of what several stores have just written waits for them.
        if (typeof(F) == typeof(Float16))
        {
            TurnEight(rows, out Vector256<float> x0, out Vector256<float> y0, out Vector256<float> z0);
            TurnEight(rows + Float8.Width, out Vector256<float> x1, out Vector256<float> y1, out Vector256<float> z1);
            x = Unsafe.BitCast<Vector512<float>, F>(LaneHalves.Join(x0, x1));
            y = Unsafe.BitCast<Vector512<float>, F>(LaneHalves.Join(y0, y1));
            z = Unsafe.BitCast<Vector512<float>, F>(LaneHalves.Join(z0, z1));
            return;
        }

        if (typeof(F) == typeof(Float8))
        {
            TurnEight(rows, out Vector256<float> x0, out Vector256<float> y0, out Vector256<float> z0);
            x = Unsafe.BitCast<Vector256<float>, F>(x0);
            y = Unsafe.BitCast<Vector256<float>, F>(y0);
            z = Unsafe.BitCast<Vector256<float>, F>(z0);
            return;
        }

        F* columns = stackalloc F[3 * Math.Max(1, Float4.Width / F.Width)];
        float* column = (float*)columns;
        for (int row = 0; row < F.Width; row += Float4.Width)
        {
            Float4.Turn(rows[row], rows[row + 1], rows[row + 2], rows[row + 3], out *(Float4*)(column + row), out *(Float4*)(column + Stride<F>() + row), out *(Float4*)(column + (2 * Stride<F>()) + row));
        }

        (x, y, z) = (*(F*)column, *(F*)(column + Stride<F>()), *(F*)(column + (2 * Stride<F>())));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void TurnEight(Float4* rows, out Vector256<float> x, out Vector256<float> y, out Vector256<float> z)
    {
        Float4.Turn(rows[0], rows[1], rows[2], rows[3], out Float4 x0, out Float4 y0, out Float4 z0);
        Float4.Turn(rows[4], rows[5], rows[6], rows[7], out Float4 x1, out Float4 y1, out Float4 z1);
        x = Vector256.Create(x0.Value, x1.Value);
        y = Vector256.Create(y0.Value, y1.Value);
        z = Vector256.Create(z0.Value, z1.Value);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int Stride<F>()
        where F : unmanaged, IReal<F> => Math.Max(F.Width, Float4.Width);

    /// <summary>Writes x0 y0 z0 x1 y1 z1 x2 y2 z2 x3 y3 z3.</summary>
    /// <param name="x">Four numbers.</param>
    /// <param name="y">Four numbers.</param>
    /// <param name="z">Four numbers.</param>
    /// <param name="to">Room for twelve numbers.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void WriteFour(float* x, float* y, float* z, float* to)
    {
        Vector128<float> xs = Vector128.Load(x), ys = Vector128.Load(y), zs = Vector128.Load(z);
        if (Sse.IsSupported)
        {
            // x0 y0 x1 y1, x2 y2 x3 y3; then z0 z0 x1 x1, y1 y1 z1 z1, z2 z2 x3 x3, y3 y3 z3 z3.
            Vector128<float> low = Sse.UnpackLow(xs, ys), high = Sse.UnpackHigh(xs, ys);
            Sse.Shuffle(low, Sse.Shuffle(zs, low, 0b10_10_00_00), 0b10_00_01_00).Store(to);
            Sse.Shuffle(Sse.Shuffle(low, zs, 0b01_01_11_11), high, 0b01_00_10_00).Store(to + 4);
            Sse.Shuffle(Sse.Shuffle(zs, high, 0b10_10_10_10), Sse.Shuffle(high, zs, 0b11_11_11_11), 0b10_00_10_00).Store(to + 8);
            return;
        }

        Vector128<float> second = Vector128.Create(0, -1, 0, 0).AsSingle();
        Vector128<float> third = Vector128.Create(0, 0, -1, 0).AsSingle();
        Vector128<float> xs0 = Vector128.Shuffle(xs, Vector128.Create(0, 0, 1, 1)), ys0 = Vector128.Shuffle(ys, Vector128.Create(1, 1, 2, 2));
        Vector128<float> zs0 = Vector128.Shuffle(zs, Vector128.Create(0, 0, 0, 0));
        Vector128<float> first = Vector128.Shuffle(ys, Vector128.Create(0, 0, 0, 0));
        Vector128.ConditionalSelect(third, zs0, Vector128.ConditionalSelect(second, first, xs0)).Store(to);
        Vector128<float> xs1 = Vector128.Shuffle(xs, Vector128.Create(2, 2, 2, 2)), zs1 = Vector128.Shuffle(zs, Vector128.Create(1, 1, 1, 1));
        Vector128.ConditionalSelect(third, xs1, Vector128.ConditionalSelect(second, zs1, ys0)).Store(to + 4);
        Vector128<float> zs2 = Vector128.Shuffle(zs, Vector128.Create(2, 2, 3, 3)), xs2 = Vector128.Shuffle(xs, Vector128.Create(3, 3, 3, 3));
        Vector128<float> ys2 = Vector128.Shuffle(ys, Vector128.Create(3, 3, 3, 3));
        Vector128.ConditionalSelect(third, ys2, Vector128.ConditionalSelect(second, xs2, zs2)).Store(to + 8);
    }
}
