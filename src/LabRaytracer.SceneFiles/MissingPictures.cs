namespace LabRaytracer;

/// <summary>What becomes of a scene whose pictures are missing or damaged.</summary>
public enum MissingPictures
{
    /// <summary>The scene is refused: with the other mistakes of the file if the picture is missing, when it is decoded if it is damaged.</summary>
    Refused,

    /// <summary>A checker of magenta and black stands in for the picture, and <see cref="SceneLoadOptions.Warned"/> is told.</summary>
    Checker,
}
