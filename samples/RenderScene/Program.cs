using RenderScene;

WarmUp.Start(args);
using SignalStop stop = new();
int code = App.Run(args, AppConsole.System(), stop.Token);
return code == ExitCode.Cancelled ? stop.ExitCode ?? code : code;
