using System.Globalization;
using System.Runtime.InteropServices;

namespace LabRaytracer.Benchmarks;

/// <summary>rays [FILE.obj]: rays a second against a mesh, by kind of ray, precision and threads, with their agreement beside.</summary>
internal static class RayCommand
{
    private const int Rounds = 7;

    public static int Run(string[] words)
    {
        string path = words.Length > 0 ? words[0] : Path.Combine(BenchPlan.Root, "scenes", "bench", "data", "torus.obj");
        if (words.Length > 1 || !File.Exists(path))
        {
            Console.Error.WriteLine($"error: there is no mesh '{path}'; make it with the verb bench-data, or name another: rays [FILE.obj].");
            return 2;
        }

        TriangleMesh mesh = ObjFile.Load(path).Parts[0].Mesh;
        Line($"{mesh.TriangleCount:#,0} triangles, {Environment.ProcessorCount} processors, lanes of {LaneWidth.Best} floats, {RuntimeInformation.FrameworkDescription}; best of {Rounds} rounds");
        foreach (int threads in (int[])[1, 2])
        {
            (double wall, double processor) = Best(() => GC.KeepAlive(mesh.BuildTree(threads)));
            Line($"build, {threads} thread(s): {1000 * wall:0} ms ({1000 * processor:0} ms of processor time), {mesh.BuildTree(threads).Bytes + mesh.Data.Bytes:#,0} bytes, {(mesh.BuildTree(threads).Bytes + mesh.Data.Bytes) / (double)mesh.TriangleCount:0.0} a triangle");
        }

        switch (LaneWidth.Best)
        {
            case 16:
                Measure<Double16, Float16, Int16>("double", mesh);
                Measure<Float16, Float16, Int16>("float", mesh);
                break;
            case 8:
                Measure<Double8, Float8, Int8>("double", mesh);
                Measure<Float8, Float8, Int8>("float", mesh);
                break;
            default:
                Measure<Double4, Float4, Int4>("double", mesh);
                Measure<Float4, Float4, Int4>("float", mesh);
                break;
        }

        return 0;
    }

    /// <summary>Seconds of wall and of processor time, each the best of all rounds.</summary>
    private static (double Wall, double Processor) Best(Action action)
    {
        double wall = double.PositiveInfinity, processor = double.PositiveInfinity;
        for (int round = 0; round < Rounds; round++)
        {
            TimeSpan before = Environment.CpuUsage.TotalTime;
            long start = System.Diagnostics.Stopwatch.GetTimestamp();
            action();
            wall = Math.Min(wall, System.Diagnostics.Stopwatch.GetElapsedTime(start).TotalSeconds);
            processor = Math.Min(processor, (Environment.CpuUsage.TotalTime - before).TotalSeconds);
        }

        return (wall, processor);
    }

    private static void Measure<R, F, I>(string precision, TriangleMesh mesh)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        using RayStreams<R, F, I> streams = new(mesh);
        foreach (RayStream<R, F, I> stream in streams.All)
        {
            foreach (int threads in (int[])[1, 2])
            {
                (double wall, double processor) = Best(() => stream.Trace(threads));
                Line($"{stream.Name,-16} {precision,-6} {threads} thread(s): {stream.RayCount / wall * 1e-6,6:0.00} M rays/s, {stream.RayCount / processor * 1e-6,6:0.00} a second of processor time; {stream.RayCount} rays, {stream.HitCount} hit; {stream.Agreement()}");
            }
        }
    }

    private static void Line(FormattableString line) => Console.WriteLine(line.ToString(CultureInfo.InvariantCulture));
}
