using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Draws samples of light from all around.</summary>
internal sealed unsafe class EnvironmentStage<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private readonly LampPlaces<R, F, I> _places;
    private readonly WorkerCounters _counters;
    private readonly ShadingBuffers<R, F, I> _buffers;
    private readonly R* _turns;
    private readonly R* _cosine;
    private readonly R* _weight;

    public EnvironmentStage(CompiledScene<R, F, I> scene, LampPlaces<R, F, I> places, WorkerCounters counters, LaneMemory memory, int capacity)
    {
        _places = places;
        _counters = counters;
        _buffers = new ShadingBuffers<R, F, I>(scene, memory, capacity, hasFootprints: false);
        _turns = memory.Column<R>(capacity, R.Width);
        _cosine = memory.Column<R>(capacity, R.Width);
        _weight = memory.Column<R>(capacity, R.Width);
    }

    /// <summary>Draws one sample for every hit.</summary>
    /// <param name="environment">The light.</param>
    /// <param name="sample">Number of the sample.</param>
    /// <param name="light">Receives the samples.</param>
    /// <param name="count">Number of hits.</param>
    public void Sample(CompiledEnvironment environment, int sample, in LightColumns<R, F> light, int count)
    {
        int packets = (count + R.Width - 1) / R.Width;
        Draw(environment, sample, packets * R.Width);
        Aim(environment.Light.Rotation, light, packets);
        _counters.Charge(RenderStage.Light);
        TextureStage.Run(environment.Sky, _buffers, count, _counters);
        for (int packet = 0; packet < packets; packet++)
        {
            F weight = R.ToSingle(_weight[packet]);
            environment.Sky.Emission.Read(_buffers.Texels, packet, out F red, out F green, out F blue);
            light.Intensity.R[packet] = red * weight;
            light.Intensity.G[packet] = green * weight;
            light.Intensity.B[packet] = blue * weight;
        }
    }

    private void Draw(CompiledEnvironment environment, int sample, int count)
    {
        int samples = environment.Light.Samples;
        EnvironmentTable table = environment.Table!;
        (uint, uint) point = LampPlaces<R, F, I>.Point(sample);
        for (int i = 0; i < count; i++)
        {
            (uint s, uint t) = _places.Fraction(i, point);
            EnvironmentSample drawn = table.Sample(SquareSequence.Unit(s), SquareSequence.Unit(t));
            R.Put(_turns, i, drawn.Turns);
            R.Put(_cosine, i, drawn.Cosine);
            R.Put(_weight, i, drawn.Weight / samples);
        }
    }

    /// <summary>Directions of the samples, in the sky's space for its texture and in the world.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Aim(Transform rotation, in LightColumns<R, F> light, int packets)
    {
        PositionBatch<R> at = _buffers.Surfaces.Positions;
        bool isTurned = !rotation.IsIdentity;
        for (int packet = 0; packet < packets; packet++)
        {
            (R x, R y, R z) = SkyDirection.At(_turns[packet], _cosine[packet]);
            at.X[packet] = at.NormalX[packet] = x;
            at.Y[packet] = at.NormalY[packet] = y;
            at.Z[packet] = at.NormalZ[packet] = z;
            (x, y, z) = isTurned ? DirectionTurn.Apply(rotation.WorldFromObjectRows, x, y, z) : (x, y, z);
            light.DirectionX[packet] = x;
            light.DirectionY[packet] = y;
            light.DirectionZ[packet] = z;
            light.Distance[packet] = R.Of(double.PositiveInfinity);
        }
    }
}
