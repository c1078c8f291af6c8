namespace LabRaytracer;

/// <summary>Everything that a picture shows: camera, objects, lamps, background (Polish: scena).</summary>
/// <remarks>
/// Editable between renders, not during one; not thread safe while it is edited.
/// World space is right-handed with +Y up; lengths are in scene units of your choice.
/// </remarks>
public sealed class Scene
{
    private Camera _camera = new PerspectiveCamera(new Point3D(0, 0, 5), Point3D.Origin, 40);
    private TextureSlot _background = Intensity.Black;
    private Transform _backgroundRotation = Transform.Identity;

    /// <summary>The camera. Default: perspective, from (0, 0, 5) to the origin, 40 degrees.</summary>
    public Camera Camera
    {
        get => _camera;
        set => _camera = value ?? throw new ArgumentNullException(nameof(value));
    }

    /// <summary>The objects, in the order of their numbers.</summary>
    public IList<SceneObject> Objects { get; } = [];

    /// <summary>The lamps.</summary>
    public IList<Light> Lights { get; } = [];

    /// <summary>
    /// What rays see that hit nothing. A texture is mapped by the ray's unit direction (default: <see cref="SphericalMapping"/>, a lat-long picture).
    /// Default: black.
    /// </summary>
    public TextureSlot Background
    {
        get => _background;
        set => _background = value ?? throw new ArgumentNullException(nameof(value));
    }

    /// <summary>Turns the background about an axis through the origin: where a direction of the picture lies in the world. Default: not turned.</summary>
    /// <exception cref="ArgumentException">The transform moves, scales or mirrors.</exception>
    public Transform BackgroundRotation
    {
        get => _backgroundRotation;
        set => _backgroundRotation = LightChecks.Rotation(value);
    }

    /// <summary>Adds an object and returns it.</summary>
    /// <param name="shape">The shape.</param>
    /// <param name="material">Its material.</param>
    /// <param name="transform">Object space to world space; null for the identity.</param>
    public SceneObject Add(Shape shape, Material material, Transform? transform = null)
    {
        SceneObject added = new(shape, material, transform);
        Objects.Add(added);
        return added;
    }
}
