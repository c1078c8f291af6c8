using System.Globalization;

namespace LabRaytracer;

/// <summary>A place in a text file.</summary>
/// <param name="File">The file, as it was named when it was opened.</param>
/// <param name="Line">Line, from 1.</param>
/// <param name="Column">Column in UTF-16 characters, from 1; a tab is one character.</param>
/// <remarks>Immutable, thread safe.</remarks>
public readonly record struct SceneLocation(string File, int Line, int Column)
{
    /// <summary>file:line:column, the form that editors and terminals turn into a link.</summary>
    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"{File}:{Line}:{Column}");
}
