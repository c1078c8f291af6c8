namespace LabRaytracer;

/// <summary>What a 3D texture is fixed to.</summary>
public enum TextureFrame
{
    /// <summary>The object: the texture moves with it.</summary>
    Object,

    /// <summary>The world: the object moves through the texture.</summary>
    World,
}
