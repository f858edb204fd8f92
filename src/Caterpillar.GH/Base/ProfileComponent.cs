namespace Caterpillar.GH.Base;

/// <summary>A component that reads profiles. It is solved again when a profile of the user changes.</summary>
[SuppressMessage("Design", "CA1001",
    Justification = "Grasshopper never disposes of components: the watcher is disposed when the component leaves its document.")]
public abstract class ProfileComponent(string name, string nickname, string description, GH_Exposure exposure)
    : CaterpillarComponent(name, nickname, description, Panel.Setup, exposure)
{
    private const int DelayMilliseconds = 200;
    private ProfileWatcher? _watcher;

    public override void AddedToDocument(GH_Document document)
    {
        base.AddedToDocument(document);
        Watch();
    }

    public override void RemovedFromDocument(GH_Document document)
    {
        Unwatch();
        base.RemovedFromDocument(document);
    }

    public override void DocumentContextChanged(GH_Document document, GH_DocumentContext context)
    {
        if (context is GH_DocumentContext.Close or GH_DocumentContext.Unloaded)
        {
            Unwatch();
        }
        else if (_watcher is null)
        {
            // Back on the canvas: profiles may have changed meanwhile.
            Watch();
            Expire();
        }
        base.DocumentContextChanged(document, context);
    }

    private void Watch() => _watcher ??= new ProfileWatcher(() => Background.Post(Expire));

    private void Unwatch()
    {
        _watcher?.Dispose();
        _watcher = null;
    }

    private void Expire() => OnPingDocument()?.ScheduleSolution(DelayMilliseconds, _ => ExpireSolution(false));
}
