namespace LabRaytracer;

/// <summary>The coordinates that the shape brings along: the interpolated vt of a mesh.</summary>
/// <remarks>
/// <para>(u, v) = <see cref="SurfacePosition.Surface"/>, unchanged and unwrapped; shapes without coordinates of their own give (0, 0).</para>
/// <list type="table">
/// <listheader><term>the shape's own (u, v)</term><description>(u, v)</description></listheader>
/// <item><term>(0, 0)</term><description>(0, 0)</description></item>
/// <item><term>(1, 0)</term><description>(1, 0)</description></item>
/// <item><term>(0, 1)</term><description>(0, 1)</description></item>
/// <item><term>(0.25, 0.75)</term><description>(0.25, 0.75)</description></item>
/// <item><term>(-0.5, 3)</term><description>(-0.5, 3)</description></item>
/// <item><term>(1, 1)</term><description>(1, 1)</description></item>
/// </list>
/// <para>Immutable, thread safe.</para>
/// </remarks>
public sealed class MeshMapping : IWideMapping
{
    /// <inheritdoc/>
    public TextureCoordinate Map(in SurfacePosition position) => position.Surface;

    /// <inheritdoc/>
    public MappingGradient Gradient(in SurfacePosition position) => position.SurfaceGradient;

    unsafe void IWideMapping.Gradients<T>(in PositionBatch<T> positions, in GradientBatch<T> gradients, int packets)
    {
        Copy(positions.SurfaceGradient.UX, gradients.UX, packets);
        Copy(positions.SurfaceGradient.UY, gradients.UY, packets);
        Copy(positions.SurfaceGradient.UZ, gradients.UZ, packets);
        Copy(positions.SurfaceGradient.VX, gradients.VX, packets);
        Copy(positions.SurfaceGradient.VY, gradients.VY, packets);
        Copy(positions.SurfaceGradient.VZ, gradients.VZ, packets);
    }

    private static unsafe void Copy<T>(T* from, T* to, int packets)
        where T : unmanaged => new ReadOnlySpan<T>(from, packets).CopyTo(new Span<T>(to, packets));

    unsafe void IWideMapping.Map<R>(in PositionBatch<R> positions, in CoordinateBatch<R> coordinates, int packets)
    {
        new ReadOnlySpan<R>(positions.SurfaceU, packets).CopyTo(new Span<R>(coordinates.U, packets));
        new ReadOnlySpan<R>(positions.SurfaceV, packets).CopyTo(new Span<R>(coordinates.V, packets));
    }
}
