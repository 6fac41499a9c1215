import { kindOf, moduleOf, type Addable } from '../addable.ts';

/** Group of what can be added. */
export interface Category {
  readonly key: string;
  readonly text: string;
  /** Number of entries without a search. */
  readonly count: number;
  has(one: Addable): boolean;
}

/** Modules that share a tag before it is a category. */
const MIN_SHARED = 3;
/** Most tags: they are seen without scrolling. */
const MAX_TAGS = 8;
/** Tells how a module is meant, not what it does. */
const IGNORED = 'example';

/** Returns the groups that have entries: all, favourites, recently used, the commonest tags of modules, topics, and the rest. */
export function categoriesOf(
  all: readonly Addable[],
  { favourites, recent }: Readonly<Record<'favourites' | 'recent', readonly string[]>>,
): Category[] {
  const isTopic = (one: Addable): boolean => kindOf(one) === 'topic';
  const isSocket = ({ port }: Addable): boolean => port !== undefined;
  const isIn =
    (names: readonly string[]) =>
    (one: Addable): boolean =>
      names.includes(moduleOf(one)?.name ?? '');
  const isRest = (one: Addable): boolean =>
    moduleOf(one) === undefined && !isTopic(one) && !isSocket(one);
  const groups: readonly Omit<Category, 'count'>[] = [
    { key: 'all', text: 'All', has: () => true },
    { key: 'sockets', text: 'In the graph', has: isSocket },
    { key: 'favourites', text: 'Favourites', has: isIn(favourites) },
    { key: 'recent', text: 'Recent', has: isIn(recent) },
    ...commonTags(all).map((tag) => ({
      key: `tag ${tag}`,
      text: tag.charAt(0).toUpperCase() + tag.slice(1),
      has: (one: Addable) => moduleOf(one)?.tags.includes(tag) === true,
    })),
    { key: 'topics', text: 'Topics', has: isTopic },
    { key: 'rest', text: 'Muxers, notes', has: isRest },
  ];
  return groups
    .map((group) => ({ ...group, count: all.filter(group.has).length }))
    .filter(({ count, key }) => count > 0 || key === 'all');
}

function commonTags(all: readonly Addable[]): string[] {
  const counts = new Map<string, number>();
  for (const one of all)
    for (const tag of new Set(moduleOf(one)?.tags)) counts.set(tag, (counts.get(tag) ?? 0) + 1);
  return [...counts]
    .filter(([tag, count]) => count >= MIN_SHARED && tag !== IGNORED)
    .sort(([, a], [, b]) => b - a)
    .slice(0, MAX_TAGS)
    .map(([tag]) => tag)
    .sort((a, b) => a.localeCompare(b));
}
