import { ModuleOrigin } from '@ubii/proto';
import { moduleOf, type Addable } from '../canvas/addable.ts';

/** What is this person's own first: topics of this browser, then modules written on this master; the rest as it was. */
export function ownFirst(found: readonly Addable[], clientId: string): Addable[] {
  return [0, 1, 2].flatMap((rank) => found.filter((one) => rankOf(one, clientId) === rank));
}

function rankOf(one: Addable, clientId: string): number {
  if (one.item?.kind === 'topic') {
    // One of the oldest topics of clients has no slash in front
    const isOwn = one.item.topic.replace(/^\//, '').startsWith(`${clientId}/`);
    return isOwn ? 0 : 2;
  }
  return moduleOf(one)?.extension?.origin === ModuleOrigin.MODULE_ORIGIN_STORED ? 1 : 2;
}
