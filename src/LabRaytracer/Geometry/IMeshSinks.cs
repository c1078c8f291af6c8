namespace LabRaytracer;

/// <summary>Makes a sink for each lane of a group, and takes what it found.</summary>
/// <typeparam name="TSink">What happens to hits.</typeparam>
internal interface IMeshSinks<TSink>
    where TSink : struct
{
    /// <summary>The sink of a lane, before its ray is followed.</summary>
    TSink Start(int lane);

    /// <summary>Takes what the ray of a lane hit.</summary>
    void End(int lane, in TSink sink);
}
