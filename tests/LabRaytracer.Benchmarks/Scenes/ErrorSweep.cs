using RenderScene;

namespace LabRaytracer.Benchmarks;

/// <summary>Time against error on s5, a fine checker to the horizon: the difference from a converged picture.</summary>
internal sealed class ErrorSweep(BenchPlan plan, Measures measures, string work, Action<string> say)
{
    /// <summary>Name in results.</summary>
    public const string Name = "s5 error";

    private static readonly int[] s_samples = [1, 4, 9, 16, 25, 64];

    private static readonly string[] s_povOptions = ["-A", "+A0.3 +R3 -J", "+A0.1 +R4 -J"];

    /// <summary>Measures our samples a pixel and POV-Ray's ways of anti-aliasing, on one thread.</summary>
    public void Run(LoadedScene scene)
    {
        say($"{Name}: converged picture, {plan.ReferenceSamples} samples a pixel");
        Picture converged = Render(scene.Scene, plan.ReferenceSamples, Environment.ProcessorCount, seed: 1).Picture;
        for (int round = 1; round <= plan.Rounds; round++)
        {
            say($"{Name}: round {round} of {plan.Rounds}");
            foreach (int samples in s_samples)
            {
                RenderResult result = Render(scene.Scene, samples, threads: 1, seed: 0);
                Add(SceneRun.Ours, FormattableString.Invariant($"{samples} samples"), result.Statistics.RenderSeconds, result.Picture, converged);
            }

            MeasurePov(scene, converged, round);
        }
    }

    // POV-Ray's finest takes long: it takes part in the first round only.
    private void MeasurePov(LoadedScene scene, Picture converged, int round)
    {
        if (!PovRay.IsInstalled)
        {
            return;
        }

        string path = PovScene.Write(scene, work, "s5", plan.Width, plan.Height), picture = Path.Combine(work, "s5-error.png");
        foreach (string options in round == 1 ? s_povOptions : s_povOptions[..1])
        {
            double seconds = PovRay.Render(path, picture, plan, options, threads: 1).TraceSeconds;
            Add(SceneRun.Pov, options, seconds, SceneRun.LoadLinear(picture), converged);
        }
    }

    private void Add(string program, string variant, double seconds, Picture picture, Picture converged)
    {
        measures.Add(Name, program, variant, "picture", seconds);
        measures.Add(Name, program, variant, "rmse", FrontierSweep.Rmse(picture, converged));
    }

    private RenderResult Render(Scene scene, int samples, int threads, int seed) => Renderer.Render(scene, new RenderOptions
    {
        Width = plan.Width, Height = plan.Height, Samples = samples, Threads = threads, Seed = seed, Pattern = samples == 1 ? SamplePattern.Regular : SamplePattern.Jittered,
    });
}
