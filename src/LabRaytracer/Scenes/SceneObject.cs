namespace LabRaytracer;

/// <summary>A shape with a material at a place in the world.</summary>
/// <remarks>Immutable, thread safe (as far as its shape is).</remarks>
public sealed class SceneObject
{
    /// <summary>Places a shape.</summary>
    /// <param name="shape">The shape.</param>
    /// <param name="material">Its material.</param>
    /// <param name="transform">Object space to world space; null for the identity.</param>
    public SceneObject(Shape shape, Material material, Transform? transform = null)
    {
        Shape = shape ?? throw new ArgumentNullException(nameof(shape));
        Material = material ?? throw new ArgumentNullException(nameof(material));
        Transform = transform ?? Transform.Identity;
    }

    /// <summary>Name for messages and statistics; may be empty.</summary>
    public string Name { get; init; } = "";

    /// <summary>The shape, in object space.</summary>
    public Shape Shape { get; }

    /// <summary>The material.</summary>
    public Material Material { get; }

    /// <summary>Object space to world space.</summary>
    public Transform Transform { get; }

    /// <summary>Tells whether the object blocks light. Default: yes.</summary>
    public bool CastsShadows { get; init; } = true;
}
