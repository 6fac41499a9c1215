import type { UbiiClient } from '@ubii/client-web';
import type { ProcessingNode } from '@ubii/client-web/processing';

/** The node of this page with browser sandboxes; its code is loaded now. */
export function openTabNode(_client: UbiiClient): Promise<ProcessingNode> {
  return Promise.reject(new Error('This build has no sandboxes for browsers.'));
}
