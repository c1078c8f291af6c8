namespace LabRaytracer;

/// <summary>The sink of a single ray.</summary>
/// <param name="sink">The sink.</param>
internal readonly struct MeshOneSink(MeshNearestSink<Double1, Float1, Int1> sink) : IMeshSinks<MeshNearestSink<Double1, Float1, Int1>>
{
    public MeshNearestSink<Double1, Float1, Int1> Start(int lane) => sink;

    public void End(int lane, in MeshNearestSink<Double1, Float1, Int1> sink)
    {
    }
}
