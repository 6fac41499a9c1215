import { existsSync, readFileSync } from 'node:fs';
import { SourceMap } from 'node:module';
import { basename } from 'node:path';
import { fileURLToPath } from 'node:url';
import { median } from '../statistics.ts';

/** A CPU profile, as far as it is read. Times are µs of the monotonic clock of the system. */
export interface CpuProfile {
  readonly startTime: number;
  readonly nodes: readonly ProfileNode[];
  readonly samples: readonly number[];
  readonly timeDeltas: readonly number[];
}

interface ProfileNode {
  readonly id: number;
  readonly callFrame: CallFrame;
  readonly children?: readonly number[];
}

interface CallFrame {
  readonly functionName: string;
  readonly url: string;
  /** From 0. */
  readonly lineNumber: number;
  readonly columnNumber: number;
}

/** Time for which a thread did one thing, without a look at its event loop in between. */
export interface Turn {
  readonly ms: number;
  /** Functions that took most of it, from the entry down. */
  readonly names: readonly string[];
}

/** Nothing to do, and native code such as the wait for events. */
const OUTSIDE = new Set(['(idle)', '(program)']);
const ROOT = '(root)';
/** Frames of Node that say nothing of what was done. */
const NODE = /^node:/;
const MAX_NAMES = 4;
/** Where samples are further apart than this many times what is usual, the thread did not run: another one had its core. */
const MAX_INTERVALS = 2;
/** A function is named when it has at least this share of the turn. */
const NAMED_SHARE = 0.3;

/**
 * The turns of a profile, longest first. Callbacks that follow each other without a pause count as one as long as they come from the
 * same entry: reads of many sockets are one turn.
 *
 * @param fromUs,untilUs of the clock of the profile
 */
export function findTurns(profile: CpuProfile, fromUs: number, untilUs: number): Turn[] {
  const nodes = new Map(profile.nodes.map((node) => [node.id, node]));
  const parents = new Map<number, number>();
  for (const { id, children } of profile.nodes)
    for (const child of children ?? []) parents.set(child, id);
  const pathOf = (id: number): ProfileNode[] => {
    const path: ProfileNode[] = [];
    for (let at: number | undefined = id; at !== undefined; at = parents.get(at)) {
      const node = nodes.get(at)!;
      if (node.callFrame.functionName !== ROOT) path.unshift(node);
    }
    return path;
  };
  const paths = new Map<number, ProfileNode[]>();
  const turns: Turn[] = [];
  let open: { entry: string; us: number; byNode: Map<ProfileNode, number> } | undefined;
  const close = (): void => {
    if (open !== undefined)
      turns.push({ ms: open.us / 1000, names: namesOf(open.byNode, open.us) });
    open = undefined;
  };
  const mostUs = MAX_INTERVALS * median(profile.timeDeltas);
  let atUs = profile.startTime;
  profile.samples.forEach((id, index) => {
    const us = Math.min(profile.timeDeltas[index + 1] ?? 0, mostUs);
    atUs += profile.timeDeltas[index] ?? 0;
    if (atUs < fromUs || atUs > untilUs) return close();
    let path = paths.get(id);
    if (path === undefined) paths.set(id, (path = pathOf(id)));
    const entry = path[0]?.callFrame.functionName ?? '';
    if (entry === '' || OUTSIDE.has(entry)) return close();
    if (open?.entry !== entry) {
      close();
      open = { entry, us: 0, byNode: new Map() };
    }
    open!.us += us;
    for (const node of path) open!.byNode.set(node, (open!.byNode.get(node) ?? 0) + us);
  });
  close();
  return turns.sort((a, b) => b.ms - a.ms);
}

function namesOf(byNode: ReadonlyMap<ProfileNode, number>, us: number): string[] {
  const large = [...byNode].filter(([, each]) => each >= NAMED_SHARE * us).map(([node]) => node);
  const ours = large.filter(({ callFrame }) => !NODE.test(callFrame.url));
  const named = (ours.length > 0 ? ours : large).map(({ callFrame }) => nameOf(callFrame));
  return [...new Set(named)].slice(-MAX_NAMES);
}

const maps = new Map<string, SourceMap | undefined>();

/** With the place in the sources, where a map is beside the program. */
function nameOf({ functionName, url, lineNumber, columnNumber }: CallFrame): string {
  const name = functionName || '(anonymous)';
  if (!url.startsWith('file:')) return url === '' ? name : `${name} (${basename(url)})`;
  const found = mapOf(url)?.findEntry(lineNumber, columnNumber);
  if (found === undefined || !('originalSource' in found)) return `${name} (${basename(url)})`;
  return `${name} (${basename(found.originalSource)}:${found.originalLine + 1})`;
}

function mapOf(url: string): SourceMap | undefined {
  if (!maps.has(url)) {
    const file = `${fileURLToPath(url)}.map`;
    maps.set(
      url,
      existsSync(file) ? new SourceMap(JSON.parse(readFileSync(file, 'utf8'))) : undefined,
    );
  }
  return maps.get(url);
}
