import { StatusProblemSeverity, type ModuleStatistics } from '@ubii/proto';
import type { Session } from '../sessions/session.ts';
import { quote } from '../texts/quote.ts';
import type { FoundProblem } from './findings.ts';

/** Share of one core that a module may take [EX-47]. */
const FULL_CORE = 0.9;
/**
 * A module whose runs, even the long ones, take less of a core came late because something else had the
 * processor [EX-47].
 */
const OWN_LATENESS = 0.2;

/** Resources that one running module uses. */
export interface ModuleLoad {
  readonly moduleId: string;
  readonly name: string;
  readonly nodeId: string;
  readonly sessionId: string;
  readonly sessionLabel: string;
  /** Of one core: runs a second times the time of one. */
  readonly coreShare: number;
  /** It loads models: it takes what a core gives, and its rate follows. */
  readonly needsAssets: boolean;
  readonly statistics: ModuleStatistics;
}

/** Resources that the modules of all active sessions use, as reported by their nodes. */
export function loadsOf(sessions: readonly Session[]): ModuleLoad[] {
  return sessions
    .filter(({ isLive }) => isLive)
    .flatMap((session) =>
      session.modules.flatMap(({ id, name, nodeId, spec, statistics }) => {
        if (statistics === undefined) return [];
        const { runsPerSecond, runP50Ms } = statistics;
        const where = { sessionId: session.id, sessionLabel: session.label };
        const coreShare = (runsPerSecond * runP50Ms) / 1000;
        const needsAssets = (spec.extension?.assets ?? []).length > 0;
        return [{ moduleId: id, name, nodeId, ...where, coreShare, needsAssets, statistics }];
      }),
    );
}

/**
 * Modules that are too slow for their mode. [EX-47]
 * @param overrunsBefore Overruns of each module at the last look.
 * @param nodeLabel Name of a node for people.
 * @param masterId The node that is no client.
 */
export function* checkModules(
  modules: readonly ModuleLoad[],
  overrunsBefore: ReadonlyMap<string, number>,
  nodeLabel: (nodeId: string) => string,
  masterId: string,
): Iterable<[key: string, FoundProblem]> {
  for (const {
    moduleId,
    name,
    nodeId,
    sessionId,
    sessionLabel,
    coreShare,
    needsAssets,
    statistics,
  } of modules) {
    const { overruns, runP95Ms, runsPerSecond } = statistics;
    const hasOverrun = overruns > (overrunsBefore.get(moduleId) ?? overruns);
    const isLate = hasOverrun && (runsPerSecond * runP95Ms) / 1000 >= OWN_LATENESS;
    if (!isLate && (needsAssets || coreShare <= FULL_CORE)) continue;
    const fact = isLate
      ? 'and start later than its mode requires'
      : `so that it takes ${Math.round(coreShare * 100)} % of a core`;
    yield [
      `module_slow ${moduleId}`,
      {
        code: 'module_slow',
        severity: StatusProblemSeverity.WARNING,
        text: `The runs of the module ${quote(name)} of the session ${quote(sessionLabel)} take ${runP95Ms.toFixed(1)} ms on ${quote(nodeLabel(nodeId))}, ${Math.round(runsPerSecond)} times a second, ${fact}.`,
        clientId: nodeId === masterId ? '' : nodeId,
        remedy: 'Lower its frequency, make its code faster, or run it on a faster node.',
        sessionId,
        moduleId,
      },
    ];
  }
}
