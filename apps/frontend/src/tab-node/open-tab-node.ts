import type { UbiiClient } from '@ubii/client-web';
import type { ProcessingNode } from '@ubii/client-web/processing';

/** The node of this page; its code and the workers are loaded now. */
export async function openTabNode(client: UbiiClient): Promise<ProcessingNode> {
  const [{ createProcessingNode }, { createBrowserSandboxes }] = await Promise.all([
    import('@ubii/client-web/processing'),
    import('@ubii/pm-sandbox/browser'),
  ]);
  return createProcessingNode(client, { sandboxes: createBrowserSandboxes(), kind: 'browser' });
}
