import { ModuleOrigin } from '@ubii/proto';
import { moduleOf, type Addable } from '../canvas/addable.ts';

/** Groups of the list, each in its original order. */
type Kind = 'own topic' | 'own module' | 'module' | 'other';
const USUAL: readonly (readonly Kind[])[] = [['own topic'], ['own module'], ['module', 'other']];
const MODULES_FIRST: readonly (readonly Kind[])[] = [
  ['own module'],
  ['module'],
  ['own topic'],
  ['other'],
];

/**
 * Sorts the user's own entries first: topics of this browser, then modules written on this master, then others in their
 * order.
 * @param hasModule of the session; false: modules before topics, which are chosen at their inputs
 */
export function ownFirst(
  found: readonly Addable[],
  clientId: string,
  hasModule: boolean,
): Addable[] {
  return (hasModule ? USUAL : MODULES_FIRST).flatMap((kinds) =>
    found.filter((one) => kinds.includes(kindOf(one, clientId))),
  );
}

function kindOf(one: Addable, clientId: string): Kind {
  if (one.item?.kind === 'topic') {
    // Topics of some old clients have no leading slash.
    const isOwn = one.item.topic.replace(/^\//, '').startsWith(`${clientId}/`);
    return isOwn ? 'own topic' : 'other';
  }
  const module = moduleOf(one);
  if (module === undefined) return 'other';
  return module.extension?.origin === ModuleOrigin.MODULE_ORIGIN_STORED ? 'own module' : 'module';
}
