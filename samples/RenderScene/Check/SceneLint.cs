using System.Globalization;
using LabRaytracer;

namespace RenderScene;

/// <summary>Finds what is allowed in a scene but seldom meant.</summary>
internal sealed class SceneLint(LoadedScene scene)
{
    private readonly Dictionary<string, PictureFacts> _facts = [];
    private readonly List<string> _findings = [];

    /// <summary>The findings, one line each: file:line:column: what; what to do.</summary>
    /// <exception cref="SceneFileException">A picture of the scene cannot be decoded.</exception>
    public IReadOnlyList<string> Run()
    {
        foreach (TextureSite site in TextureSite.Of(scene.Scene))
        {
            if (site.Texture is Texture { Path.Length: > 0 } picture)
            {
                CheckPicture(site, picture);
            }
        }

        return [.. _findings.Distinct()];
    }

    private void CheckPicture(TextureSite site, Texture picture)
    {
        PictureFacts facts = Facts(picture);
        CheckColorSpace(site, picture, facts);
        CheckShape(site, picture, facts);
        CheckOutside(site, picture);
        CheckContent(site, picture, facts);
        if (site.NormalMap is { } map)
        {
            CheckNormals(site, picture, facts, map);
        }
    }

    private void CheckColorSpace(TextureSite site, Texture picture, PictureFacts facts)
    {
        if (!site.IsData && picture.Sampling.ColorSpace == ColorSpace.Auto && facts.ColorDoubt is { } doubt)
        {
            Report(site, picture, $"its colours may be off: {doubt}; save it as sRGB, or say colorSpace");
        }

        if (site.IsData && site.Channel != TextureChannel.Alpha && picture.Sampling.ColorSpace == ColorSpace.Srgb)
        {
            Report(site, picture, "data is decoded as sRGB, which bends its numbers; leave colorSpace out, or say linear");
        }

        if (!site.IsData && picture.Sampling.ColorSpace == ColorSpace.Linear)
        {
            Report(site, picture, "a colour is read as linear; leave colorSpace out unless the file's numbers are linear light");
        }
    }

    private void CheckShape(TextureSite site, Texture picture, PictureFacts facts)
    {
        bool isWhole = site.Transform.IsIdentity && !site.IsDecal;
        if (site.Mapping is SphericalMapping && isWhole && facts.Width != 2 * facts.Height && facts.Width > 1)
        {
            Report(site, picture, Text($"{facts.Width} x {facts.Height} texels on a sphere, where 2:1 fits; it is stretched, which costs nothing but may look odd"));
        }

        bool isClosed = site.Mapping is SphericalMapping or CylindricalMapping;
        if (isClosed && isWhole && facts.Width > 2)
        {
            (double edges, double inside) = facts.SeamSteps();
            if (edges > 8 && edges > 1.5 * inside)
            {
                Report(site, picture, Text($"its left and right edges differ by {edges:0} codes, neighbours inside by at most {inside:0}: a seam will show; use a picture that closes"));
            }
        }
    }

    private void CheckOutside(TextureSite site, Texture picture)
    {
        if (site.IsDecal || site.Transform.IsIdentity)
        {
            return;
        }

        TextureCoordinate[] corners = [.. new[] { (0, 0), (1, 0), (0, 1), (1, 1) }.Select(corner => site.Transform.Apply(new TextureCoordinate(corner.Item1, corner.Item2)))];
        if (IsDrawnOut(picture.Sampling.WrapU, site.Mapping.DefaultWrapU) && corners.Any(corner => IsOutside(corner.U)))
        {
            Report(site, picture, "its transform leads outside [0, 1] in u, where the edge texels are drawn out; say wrapU repeat, mirror or border");
        }

        if (IsDrawnOut(picture.Sampling.WrapV, site.Mapping.DefaultWrapV) && corners.Any(corner => IsOutside(corner.V)))
        {
            Report(site, picture, "its transform leads outside [0, 1] in v, where the edge texels are drawn out; say wrapV repeat, mirror or border");
        }
    }

    /// <summary>Tells whether edge texels go on where nobody asked for it.</summary>
    private static bool IsDrawnOut(TextureWrap? asked, TextureWrap byMapping) => asked is null && byMapping is (TextureWrap.Clamp or TextureWrap.Pole);

    private void CheckContent(TextureSite site, Texture picture, PictureFacts facts)
    {
        if (site.Slot == "opacity" && site.Channel == TextureChannel.Luminance && facts.HasAlpha)
        {
            Report(site, picture, "the picture has alpha, but its luminance is read; say channel alpha if that is meant");
        }

        if (site.Channel == TextureChannel.Alpha && !facts.HasAlpha && !picture.HasAlpha)
        {
            Report(site, picture, "its alpha is read, which is 1 everywhere; say another channel");
        }

        if (site.Slot == "bump" && facts.LooksLikeNormals)
        {
            Report(site, picture, "it looks like a normal map, but is read as heights; say normalMap");
        }
    }

    private void CheckNormals(TextureSite site, Texture picture, PictureFacts facts, NormalMap map)
    {
        if (facts.IsGrey || (facts.Mean.B < 0.6f && !map.RebuildZ))
        {
            Report(site, picture, "it does not look like a normal map, which is blue; say bump if it has heights, rebuildZ if it has two channels");
            return;
        }

        (double up, double down) = facts.Curls();
        (double asRead, double flipped) = map.FlipGreen ? (down, up) : (up, down);
        if (flipped < 0.5 * asRead)
        {
            Report(site, picture, map.FlipGreen
                ? "its normals are those of a surface with green up, but are read as green down; leave flipGreen out"
                : "its normals are those of a surface with green down (DirectX), but are read as green up; say flipGreen");
        }
    }

    private PictureFacts Facts(Texture picture)
    {
        if (!_facts.TryGetValue(picture.Path, out PictureFacts? facts))
        {
            try
            {
                facts = new PictureFacts(picture.Path);
            }
            catch (PictureFormatException failure)
            {
                throw scene.SourceMap.Explain(picture, failure);
            }

            _facts[picture.Path] = facts;
        }

        return facts;
    }

    private void Report(TextureSite site, Texture picture, string what)
    {
        string place = scene.SourceMap.TryLocate(picture, out SceneLocation location) ? location.ToString() : picture.Path;
        _findings.Add($"{place}: {site.Slot} of {site.Owner}: {what}.");
    }

    // A hair outside is rounding.
    private static bool IsOutside(double coordinate) => coordinate is < -1e-9 or > 1 + 1e-9;

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
