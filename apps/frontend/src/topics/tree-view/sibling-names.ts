import { sortedNames, type SortedNames } from '../../ui/names/distinct-part.ts';
import { nameOf } from '../rows/row-view.ts';
import type { FindPublisher } from '../names/publisher.ts';
import type { TopicNode } from '../tree/topic-node.ts';

/** Cached by the array of children, which is replaced whenever a child is added, removed or renamed. */
const names = new WeakMap<readonly TopicNode[], SortedNames>();

/** Names of the rows below the same branch, to shorten a name among them. */
export function siblingNames(node: TopicNode, findPublisher: FindPublisher): SortedNames {
  const siblings = node.parent?.sorted ?? [];
  let found = names.get(siblings);
  if (found === undefined) {
    found = sortedNames(siblings.map((sibling) => nameOf(sibling, findPublisher)));
    names.set(siblings, found);
  }
  return found;
}
