using System.Text;
using RenderScene;

namespace LabRaytracer.Tests.SceneFiles;

/// <summary>Scenes that nobody would write: what the schema allows, at random.</summary>
public sealed class RandomSceneTests
{
    private const int ScenesInABatch = 12;

    /// <summary>
    /// Every scene is refused with a message or rendered: without a failure, in every view, all pixels finite, with the same bits by one and three threads, and a part of the picture with
    /// those of the whole.
    /// </summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    [InlineData(5)]
    [InlineData(6)]
    [InlineData(7)]
    public void Render_WhatTheSchemaAllows_IsFiniteAndTheSameForAnyThreads(int batch)
    {
        int rendered = 0;
        string folder = Path.GetDirectoryName(Path.GetFullPath(SampleScenes.File("scene.schema.json")))!;
        for (int seed = batch * ScenesInABatch; seed < (batch + 1) * ScenesInABatch; seed++)
        {
            string json = RandomScene.Create(seed);
            LoadedScene scene;
            try
            {
                scene = SceneFile.Read(new SceneSource("s.json", Encoding.UTF8.GetBytes(json)), folder, SceneLoadOptions.Default);
            }
            catch (SceneFileException refusal)
            {
                Assert.StartsWith("s.json:1:", refusal.Message);
                continue;
            }

            rendered++;
            try
            {
                Check(scene, seed);
            }
            catch (Exception failure) when (failure is not Xunit.Sdk.XunitException)
            {
                Assert.Fail($"Seed {seed}: {failure}\n{json}");
            }
        }

        Assert.InRange(rendered, ScenesInABatch * 2 / 3, ScenesInABatch);
    }

    private static void Check(LoadedScene loaded, int seed)
    {
        RenderOptions said = loaded.RenderOptions;
        Picture Show(int threads, Precision precision, RenderView view = RenderView.Color, TextureFilter? filter = null, PixelRectangle? crop = null, double budget = 0) => Renderer.Render(
            loaded.Scene,
            new RenderOptions
            {
                Width = said.Width, Height = said.Height, Samples = said.Samples, Pattern = said.Pattern, PixelFilter = said.PixelFilter, ErrorBudget = budget, MaxSamples = said.MaxSamples,
                EdgeSamples = said.EdgeSamples, MaxDepth = said.MaxDepth, Seed = said.Seed, Threads = threads, Precision = precision, View = view, Filter = filter, Crop = crop,
            }).Picture;
        Picture whole = Show(1, Precision.Double), part = Show(2, Precision.Double, crop: new PixelRectangle(3, 2, 9, 5));
        TextureFilter filter = (TextureFilter)(seed % (int)TextureFilter.Area);
        Picture[] pictures =
        [
            whole, Show(3, Precision.Double, budget: said.ErrorBudget), Show(2, Precision.Single), Show(2, Precision.Exact), Show(2, Precision.Double, RenderView.Color, filter),
            .. Enum.GetValues<RenderView>().Select(view => Show(1, Precision.Double, view)),
        ];
        for (int i = 0; i < pictures.Length; i++)
        {
            Assert.True(pictures[i].Pixels.ToArray().All(IsFinite), $"Seed {seed}, picture {i}.");
        }

        Assert.Equal(whole.Pixels.ToArray(), Show(3, Precision.Double).Pixels.ToArray());
        for (int y = 0; y < part.Height; y++)
        {
            Assert.Equal(whole.Row(y + 2).Slice(3, part.Width).ToArray(), part.Row(y).ToArray());
        }
    }

    private static bool IsFinite(Intensity color) => float.IsFinite(color.R) && float.IsFinite(color.G) && float.IsFinite(color.B);
}
