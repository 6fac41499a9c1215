import { ModuleOrigin } from '@ubii/proto';
import { moduleOf, type Addable } from '../canvas/addable.ts';

/** What is listed one after the other; each as it was found. */
type Kind = 'own topic' | 'own module' | 'module' | 'other';
const USUAL: readonly (readonly Kind[])[] = [['own topic'], ['own module'], ['module', 'other']];
const MODULES_FIRST: readonly (readonly Kind[])[] = [
  ['own module'],
  ['module'],
  ['own topic'],
  ['other'],
];

/**
 * What is this person's own first: topics of this browser, then modules written on this master; the rest as it was.
 * @param hasModule of the session: without one, modules come before topics, which are chosen at their inputs
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
    // One of the oldest topics of clients has no slash in front
    const isOwn = one.item.topic.replace(/^\//, '').startsWith(`${clientId}/`);
    return isOwn ? 'own topic' : 'other';
  }
  const module = moduleOf(one);
  if (module === undefined) return 'other';
  return module.extension?.origin === ModuleOrigin.MODULE_ORIGIN_STORED ? 'own module' : 'module';
}
