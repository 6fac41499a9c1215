import { ProcessingModuleStatus, SessionState, type ProcessingModule } from '@ubii/proto';
import type { MarkedState } from '../../ui/UiStateMark.vue';

/** Display of a module's status. */
export interface StatusLook {
  readonly mark: MarkedState;
  readonly word: string;
}

const LOOKS: Readonly<Record<ProcessingModuleStatus, StatusLook>> = {
  [ProcessingModuleStatus.INITIALIZED]: { mark: 'stopped', word: 'Not running' },
  [ProcessingModuleStatus.CREATED]: { mark: 'away', word: 'Ready' },
  [ProcessingModuleStatus.PROCESSING]: { mark: 'live', word: 'Running' },
  [ProcessingModuleStatus.HALTED]: { mark: 'paused', word: 'Paused' },
  [ProcessingModuleStatus.DESTROYED]: { mark: 'stopped', word: 'Ended' },
};

const ALIVE: ReadonlySet<number> = new Set([
  SessionState.SESSION_RUNNING,
  SessionState.SESSION_DEGRADED,
]);

/** @param hasError whether the session has an error of this module */
export function moduleStatus(
  { status }: Pick<ProcessingModule, 'status'>,
  session: SessionState,
  hasError: boolean,
): StatusLook {
  const runs = status === ProcessingModuleStatus.PROCESSING;
  if (hasError) return { mark: 'error', word: runs ? 'Failing' : 'Failed' };
  if (session === SessionState.SESSION_STARTING && !runs) return { mark: 'away', word: 'Starting' };
  if (ALIVE.has(session) && !runs) return { mark: 'warning', word: 'Not running' };
  return LOOKS[status] ?? LOOKS[ProcessingModuleStatus.INITIALIZED];
}
