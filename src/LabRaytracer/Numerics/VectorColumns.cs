using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Columns of vectors.</summary>
/// <typeparam name="T">Lane type.</typeparam>
internal readonly unsafe struct VectorColumns<T>
    where T : unmanaged, IReal<T>
{
    /// <summary>Components.</summary>
    public readonly T* X, Y, Z;

    /// <summary>Columns that exist already.</summary>
    public VectorColumns(T* x, T* y, T* z)
    {
        X = x;
        Y = y;
        Z = z;
    }

    /// <summary>New columns.</summary>
    /// <param name="memory">Owns them.</param>
    /// <param name="capacity">Scalars in each.</param>
    public VectorColumns(LaneMemory memory, int capacity)
        : this(memory.Column<T>(capacity, T.Width), memory.Column<T>(capacity, T.Width), memory.Column<T>(capacity, T.Width))
    {
    }

    /// <summary>Writes one group of lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Store(int packet, T x, T y, T z)
    {
        X[packet] = x;
        Y[packet] = y;
        Z[packet] = z;
    }

    /// <summary>Writes the lanes of a mask, keeps the others.</summary>
    public void Merge(int packet, T mask, T x, T y, T z) =>
        Store(packet, T.Select(mask, x, X[packet]), T.Select(mask, y, Y[packet]), T.Select(mask, z, Z[packet]));

    /// <summary>Adds a multiple of other columns to a group of lanes.</summary>
    public void Add(int packet, T factor, in VectorColumns<T> other) =>
        Store(packet, T.Fma(factor, other.X[packet], X[packet]), T.Fma(factor, other.Y[packet], Y[packet]), T.Fma(factor, other.Z[packet], Z[packet]));

    /// <summary>Copies groups of lanes.</summary>
    public void CopyFrom(in VectorColumns<T> other, int packets)
    {
        new ReadOnlySpan<T>(other.X, packets).CopyTo(new Span<T>(X, packets));
        new ReadOnlySpan<T>(other.Y, packets).CopyTo(new Span<T>(Y, packets));
        new ReadOnlySpan<T>(other.Z, packets).CopyTo(new Span<T>(Z, packets));
    }

    /// <summary>Writes one vector, rounded.</summary>
    public void Put(int element, Vector3D value)
    {
        Lane.Put(X, element, value.X);
        Lane.Put(Y, element, value.Y);
        Lane.Put(Z, element, value.Z);
    }

    /// <summary>Reads one vector.</summary>
    public Vector3D Take(int element) => new(Lane.Take(X, element), Lane.Take(Y, element), Lane.Take(Z, element));
}
