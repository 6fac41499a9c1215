import type { Session as SessionMessage, SessionProblem } from '@ubii/proto';
import type { SessionDraft } from './draft.ts';
import { sortProblems } from './problems.ts';
import { SessionModule } from './session-module.ts';
import { isLive, wireState, wireStatus, type SessionLife } from './session-states.ts';

/** Name and settings of a session: everything except its modules. */
export type SessionDescription = Omit<SessionDraft, 'modules'>;

/** The master that ran a session before this one. */
export interface SessionMove {
  /** Its name; empty when it is not known. */
  readonly from: string;
  /** When this master took the session over, epoch milliseconds. */
  readonly atMs: number;
}

/** Modules that are started and stopped together. */
export class Session {
  readonly id: string;
  description: SessionDescription;
  modules: SessionModule[];
  life: SessionLife = 'created';
  /** When it came to that state, monotonic milliseconds. */
  lifeSinceMs = 0;
  /** Encoded bytes of the request it was made of. */
  byteLength = 0;
  /** Grows with every change of the specification [SE-15]. */
  revision = 1;
  /** Grants whose clients made or changed it [AC-90]. */
  readonly grantIds: Set<string>;
  /** A stored session has its name [SE-21]. */
  isStored: boolean;
  /** Warnings about its specification from the last check [SE-5]. */
  warnings: readonly SessionProblem[] = [];
  /** Problems of its life besides those of modules, by their own keys [SE-12]. */
  readonly troubles = new Map<string, SessionProblem>();
  /** All its modules ran at once since it was started: `/info/session/running` was published. */
  wasRunning = false;
  /** This master in a cluster; empty for one that is alone. [CU-71] */
  masterId = '';
  /** It was taken over from a lost master. [CU-32] */
  move: SessionMove | undefined = undefined;
  /** Another master runs it now: what is stored of it is that master's. [CU-34] */
  isGivenUp = false;
  /** The master started it at startup, and no user since. Only users stop it [SE-24]. */
  isRestored = false;
  /** When it was told to stop, monotonic milliseconds. */
  stoppingSinceMs: number | undefined = undefined;

  constructor(id: string, draft: SessionDraft, isStored: boolean, grantIds: Iterable<string> = []) {
    const { modules, ...description } = draft;
    this.id = id;
    this.description = description;
    this.modules = modules.map((module) => createModule(module));
    this.isStored = isStored;
    this.grantIds = new Set(grantIds);
  }

  get isLive(): boolean {
    return isLive(this.life);
  }

  get isPaused(): boolean {
    return this.life === 'paused';
  }

  /** Name and id as they stand in messages for people. */
  get label(): string {
    const { name } = this.description;
    return name === '' ? this.id : name;
  }

  module(id: string): SessionModule | undefined {
    return this.modules.find((module) => module.id === id);
  }

  modulesOn(nodeId: string): SessionModule[] {
    return this.modules.filter((module) => module.nodeId === nodeId);
  }

  /** Memory of its modules on a node, bytes, as far as it was told; what is being made counts as the least. */
  memoryOn(nodeId: string): number {
    return this.modules.reduce(
      (sum, module) => sum + (module.nodeId === nodeId ? module.memoryBytes : 0),
      0,
    );
  }

  /** Topics that outputs are mapped to; those of demuxers show only when they run. */
  outputTopics(): Set<string> {
    return new Set(
      this.modules.flatMap(({ mapping }) =>
        mapping.outputMappings.flatMap(({ topic }) => topic || []),
      ),
    );
  }

  /** Lists the current problems, errors first. */
  problems(): SessionProblem[] {
    const ofModules = this.modules.flatMap(({ problem }) => problem ?? []);
    return sortProblems([...ofModules, ...this.troubles.values(), ...this.warnings]);
  }

  /** The session as others see it. */
  toMessage(): SessionMessage {
    const { name, tags, description, authors, editable } = this.description;
    const { startWithMaster, lockstepHertz, editorJson } = this.description;
    return {
      id: this.id,
      name,
      processingModules: this.modules.map((module) => module.toMessage(this.id, this.isPaused)),
      ioMappings: this.modules.map((module) => module.mapping),
      tags: [...tags],
      description,
      authors: [...authors],
      status: wireStatus(this.life),
      editable,
      extension: {
        state: wireState(this.life),
        problems: this.problems(),
        startWithMaster,
        lockstepHertz,
        editorJson,
        revision: this.revision,
        stored: this.isStored,
        grantIds: [...this.grantIds],
        masterId: this.masterId,
        movedFrom: this.move?.from ?? '',
        movedMs: this.move?.atMs ?? 0,
      },
    };
  }
}

/** A module of a session, out of its draft. */
export function createModule(draft: SessionDraft['modules'][number]): SessionModule {
  const { spec, mapping, wishedNodeId, isLibraryCode } = draft;
  return new SessionModule({ spec, mapping, wishedNodeId, isTrusted: isLibraryCode });
}
