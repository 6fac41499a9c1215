import type { UbiiClient } from '@ubii/client-web';
import type { ProcessingNode } from '@ubii/client-web/processing';

/** The node of this page; its code, the library and the workers are loaded now. */
export async function openTabNode(client: UbiiClient): Promise<ProcessingNode> {
  const [
    { createProcessingNode },
    { createAssetStore, createHttpAssets },
    { createBrowserSandboxes },
    { moduleLibrary },
    { partyModules },
  ] = await Promise.all([
    import('@ubii/client-web/processing'),
    import('@ubii/pm-sandbox'),
    import('@ubii/pm-sandbox/browser'),
    import('@ubii/modules'),
    import('@ubii/party/modules'),
  ]);
  return createProcessingNode(client, {
    sandboxes: createBrowserSandboxes(),
    assets: createAssetStore(createHttpAssets(location.origin)),
    // Ours: they run at full speed. Whatever else a session brings is sandboxed. [PM-51]
    modules: [...moduleLibrary(), ...partyModules()],
    kind: 'browser',
  });
}
