import type { ProcessingModule, Session } from '@ubii/proto';
import { plural } from '@ubii/words';
import { graphOf } from './graph-of.ts';
import { applyCommand } from './commands/apply-command.ts';
import { sessionOf } from './session-of.ts';
import { withIds } from './with-ids.ts';

/**
 * Fills in modules that a session only names from the library, as a master does [SE-1], so that an exported file is
 * complete.
 */
export function completeSession(session: Session, library: readonly ProcessingModule[]): Session {
  const known = new Map(library.map((module) => [module.name, module]));
  const processingModules = session.processingModules.map((module) => {
    const stored = hasCode(module) ? undefined : known.get(module.name);
    return stored === undefined ? module : completed(module, stored);
  });
  const isSame = processingModules.every((one, index) => one === session.processingModules[index]);
  return isSame ? session : { ...session, processingModules };
}

const hasCode = (module: ProcessingModule): boolean => module.onProcessingStringified !== '';

/** The session's own properties take precedence. */
function completed(module: ProcessingModule, stored: ProcessingModule): ProcessingModule {
  const said = Object.entries(module).filter(([, value]: [string, unknown]) => !isNothing(value));
  return {
    ...stored,
    ...(Object.fromEntries(said) as Partial<ProcessingModule>),
    id: module.id,
    nodeId: module.nodeId,
    sessionId: '',
    status: 0,
  };
}

const isNothing = (value: unknown): boolean =>
  value === undefined ||
  value === '' ||
  value === 0 ||
  (Array.isArray(value) && value.length === 0);

/** A session with unknown modules muted. */
export interface WithPlaceholders {
  readonly session: Session;
  /** Names of modules without code that no node offers, without duplicates. */
  readonly missing: readonly string[];
}

/**
 * Mutes unknown modules and keeps them completely, with their wires: a master refuses a session that has to run them.
 * [SE-4] They are enabled again when a node offers them.
 * @param uuid returns a new UUID
 */
export function withPlaceholders(
  session: Session,
  library: readonly ProcessingModule[],
  uuid: () => string,
): WithPlaceholders {
  const known = new Set(library.map(({ name }) => name));
  const base = withIds(session, uuid);
  const missing = base.processingModules.filter(
    (module) => !hasCode(module) && !known.has(module.name),
  );
  if (missing.length === 0) return { session, missing: [] };
  const graph = graphOf(base);
  const ids = new Set(missing.map(({ id }) => id));
  const nodes = [...graph.nodes.values()].flatMap((node) =>
    node.kind === 'module' && ids.has(node.module.id) ? [node.id] : [],
  );
  const muted = applyCommand(graph, { kind: 'setStanding', nodes, standing: 'muted' });
  return {
    session: sessionOf(muted.graph, base),
    missing: [...new Set(missing.map(({ name }) => name || 'a module without a name'))],
  };
}

/** One sentence about the missing modules; empty when none is missing. */
export function missingWords(missing: readonly string[]): string {
  if (missing.length === 0) return '';
  const what = plural(
    missing.length,
    `The module ${missing[0]!} is unknown. The import keeps it as a muted placeholder`,
    `${missing.length} modules are unknown: ${missing.join(', ')}. The import keeps them as muted placeholders`,
  );
  return `${what} with all wires.`;
}
