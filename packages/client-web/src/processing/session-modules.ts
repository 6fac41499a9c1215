import { SessionState, SessionStatus } from '@ubii/proto';
import type { IOMapping, ProcessingModule, Session } from '@ubii/proto';

/** A module that a session wants to have here. */
export interface AssignedModule {
  readonly sessionId: string;
  readonly sessionName: string;
  /** As the session says it: maybe without code. */
  readonly module: ProcessingModule;
  readonly mapping: IOMapping;
  /** True: it is to be there, but not to process. [SE-14] */
  readonly isPaused: boolean;
}

/** State that a session wants for its modules. */
export type SessionActivity = 'active' | 'paused' | 'over';

const ACTIVITIES: { readonly [S in SessionState]: SessionActivity } = {
  [SessionState.SESSION_CREATED]: 'over',
  [SessionState.SESSION_STARTING]: 'active',
  [SessionState.SESSION_RUNNING]: 'active',
  [SessionState.SESSION_DEGRADED]: 'active',
  [SessionState.SESSION_PAUSED]: 'paused',
  [SessionState.SESSION_STOPPING]: 'over',
  [SessionState.SESSION_STOPPED]: 'over',
};

/**
 * State in the message of a session; `undefined` when it is ambiguous: CREATED of an original master is
 * a session that starts as well as one that does not. [SE-10]
 */
export function activityOf({ extension, status }: Session): SessionActivity | undefined {
  if (extension !== undefined) return ACTIVITIES[extension.state] ?? 'over';
  if (status === SessionStatus.CREATED) return undefined;
  return status === SessionStatus.RUNNING ? 'active' : 'over';
}

/** The modules of a session that belong on the node. [PM-62] */
export function modulesFor(
  session: Session,
  nodeId: string,
  activity: SessionActivity,
): AssignedModule[] {
  if (activity === 'over') return [];
  return session.processingModules
    .filter((module) => module.nodeId === nodeId && module.id !== '')
    .map((module) => ({
      sessionId: session.id,
      sessionName: session.name,
      module: { ...module, sessionId: session.id },
      mapping: mappingOf(session, module),
      isPaused: activity === 'paused',
    }));
}

function mappingOf({ ioMappings }: Session, { id, name }: ProcessingModule): IOMapping {
  return (
    ioMappings.find(({ processingModuleId }) => processingModuleId === id) ??
    ioMappings.find(
      (mapping) => mapping.processingModuleId === '' && mapping.processingModuleName === name,
    ) ?? {
      processingModuleId: id,
      processingModuleName: name,
      inputMappings: [],
      outputMappings: [],
    }
  );
}
