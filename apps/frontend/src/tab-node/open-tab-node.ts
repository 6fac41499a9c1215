import type { UbiiClient } from '@ubii/client-web';
import type { ProcessingNode } from '@ubii/client-web/processing';

/** Creates the node of this page; loads its code, the library and the workers. */
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
    assets: createAssetStore(createHttpAssets(() => client.masterUrl ?? location.origin)),
    // Trusted modules, which run at full speed. Other modules of sessions are sandboxed. [PM-51]
    modules: [...moduleLibrary(), ...partyModules()],
    kind: 'browser',
  });
}
