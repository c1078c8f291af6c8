namespace LabRaytracer;

/// <summary>What a value of a JSON file is.</summary>
internal enum NodeKind : byte
{
    Object,
    Array,
    Text,
    Number,
    True,
    False,
    Null,
}
