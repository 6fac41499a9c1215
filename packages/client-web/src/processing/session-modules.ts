import { SessionState, SessionStatus } from '@ubii/proto';
import type { WantedInstance } from '@ubii/pm-sandbox';
import type { IOMapping, ProcessingModule, Session } from '@ubii/proto';
import type { ModuleCatalog } from './module-catalog.ts';

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

/** The modules of a session that belong on the node, with the code that it has for them. [PM-62] */
export function instancesFor(
  session: Session,
  nodeId: string,
  activity: SessionActivity,
  catalog: ModuleCatalog,
): WantedInstance[] {
  if (activity === 'over') return [];
  return session.processingModules
    .filter((module) => module.nodeId === nodeId && module.id !== '')
    .map((asked) => {
      const { module, isTrusted, fault } = catalog.resolve({ ...asked, sessionId: session.id });
      return {
        spec: { module, mapping: mappingOf(session, asked), isTrusted },
        isPaused: activity === 'paused',
        revision: session.extension?.revision ?? 0,
        fault,
      };
    });
}

/** Topics that outputs of a session's modules on the node are mapped to by name. */
export function outputTopicsOf(session: Session, nodeId: string): string[] {
  return session.processingModules
    .filter((module) => module.nodeId === nodeId)
    .flatMap((module) => outputTopics(mappingOf(session, module)));
}

/** Topics that a mapping names for outputs; those of demuxers are not among them. */
export function outputTopics({ outputMappings }: IOMapping): string[] {
  return outputMappings.flatMap(({ topic }) => (topic ? [topic] : []));
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
