namespace LabRaytracer.PublicApi.Tests;

/// <summary>A student's shape that asks a built-in one, one ray at a time.</summary>
internal sealed class BorrowedShape(Shape lender, IMapping mapping) : Shape
{
    public override Bounds Bounds => lender.Bounds;

    public override IMapping DefaultMapping => mapping;

    public override bool Intersect(in Ray ray, double limit, out Hit hit) => lender.Intersect(ray, limit, out hit);

    public override SurfacePoint SurfaceAt(in Ray ray, in Hit hit) => lender.SurfaceAt(ray, hit);
}

/// <summary>A student's mapping that asks a built-in one, one point at a time.</summary>
internal sealed class BorrowedMapping(IMapping lender) : IMapping
{
    public TextureWrap DefaultWrapU => lender.DefaultWrapU;

    public TextureWrap DefaultWrapV => lender.DefaultWrapV;

    public TextureCoordinate Map(in SurfacePosition position) => lender.Map(position);
}

/// <summary>A student's texture that asks a built-in one, one lookup at a time.</summary>
internal sealed class BorrowedTexture(ITexture lender) : ITexture
{
    public TextureNeeds Needs => lender.Needs;

    public Intensity Sample(in TextureLookup lookup) => lender.Sample(lookup);
}

/// <summary>A student's lamp that asks a built-in one, one point at a time.</summary>
internal sealed class BorrowedLight(Light lender) : Light
{
    public override bool TrySample(Point3D point, out LightSample sample) => lender.TrySample(point, out sample);
}

/// <summary>A student's lighting model that asks a built-in one, one point at a time.</summary>
internal sealed class BorrowedShader(IShader lender) : IShader
{
    public bool UsesSpecular => lender.UsesSpecular;

    public Intensity Reflect(in SurfaceValues values, Vector3D normal, Vector3D toLight, Vector3D toViewer) =>
        lender.Reflect(values, normal, toLight, toViewer);
}

/// <summary>A student's camera that asks a built-in one, one ray at a time.</summary>
internal sealed class BorrowedCamera(Camera lender) : Camera
{
    public override Ray RayAt(double x, double y, int width, int height) => lender.RayAt(x, y, width, height);
}
