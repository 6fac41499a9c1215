import { isSameValue, type Session as SessionMessage, type SessionProblem } from '@ubii/proto';
import type { GrantId } from '../access/grant.ts';
import type { DraftModule } from './complete-modules.ts';
import { sortProblems } from './problems.ts';
import { SessionModule } from './session-module.ts';
import {
  isLive,
  nextLife,
  wireState,
  wireStatus,
  type SessionEvent,
  type SessionLife,
} from './session-states.ts';

/** Name and settings of a session: everything except its modules. */
export interface SessionDescription {
  readonly name: string;
  readonly tags: readonly string[];
  readonly description: string;
  readonly authors: readonly string[];
  readonly editable: boolean;
  readonly startWithMaster: boolean;
  readonly lockstepHertz: number;
  readonly editorJson: string;
}

/** Specification of a session, from a request that was completed and checked. */
export interface SessionContent {
  /** Request with the name and the settings. */
  readonly message: SessionMessage;
  readonly modules: readonly DraftModule[];
  /** Encoded size of the request. */
  readonly byteLength: number;
  /** Warnings about the specification. [SE-5] */
  readonly warnings?: readonly SessionProblem[];
  /** Grants of the clients that created or changed it. [AC-90] */
  readonly grantIds: Iterable<GrantId>;
}

/** The master that ran a session before this one. */
export interface SessionMove {
  /** Its name; undefined when it is not known. */
  readonly from: string | undefined;
  /** When this master took the session over, epoch milliseconds. */
  readonly atMs: number;
}

/** Modules that are started and stopped together. */
export class Session {
  readonly id: string;
  /** This master in a cluster; undefined for one that is alone. [CU-71] */
  readonly masterId: string | undefined;
  /** Set when the session was taken over from a lost master. [CU-32] */
  readonly move: SessionMove | undefined;
  /** Problems while it runs, except those of modules, by their own keys [SE-12]. */
  readonly troubles = new Map<string, SessionProblem>();
  readonly #grantIds: Set<GrantId>;
  #description: SessionDescription;
  #modules: readonly SessionModule[];
  #byteLength: number;
  #revision: number;
  #isStored: boolean;
  #warnings: readonly SessionProblem[];
  #life: SessionLife = 'created';
  #lifeSinceMs = 0;
  #hasRun = false;
  #isRestored = false;
  #isGivenUp = false;

  /** @param init.revision default 1 */
  constructor(
    init: SessionContent & {
      readonly id: string;
      readonly masterId: string | undefined;
      readonly isStored: boolean;
      readonly revision?: number;
      readonly move?: SessionMove | undefined;
    },
  ) {
    this.id = init.id;
    this.masterId = init.masterId;
    this.move = init.move;
    this.#description = describe(init.message);
    this.#modules = init.modules.map((module) => new SessionModule(module));
    this.#byteLength = init.byteLength;
    this.#warnings = init.warnings ?? [];
    this.#grantIds = new Set(init.grantIds);
    this.#isStored = init.isStored;
    this.#revision = init.revision ?? 1;
  }

  get description(): SessionDescription {
    return this.#description;
  }

  get modules(): readonly SessionModule[] {
    return this.#modules;
  }

  /** Encoded size of the request that it was made from. */
  get byteLength(): number {
    return this.#byteLength;
  }

  /** Grows with every change of the specification [SE-15]. */
  get revision(): number {
    return this.#revision;
  }

  /** Grants of the clients that created or changed it [AC-90]. */
  get grantIds(): ReadonlySet<GrantId> {
    return this.#grantIds;
  }

  /** A stored session has its name [SE-21]. */
  get isStored(): boolean {
    return this.#isStored;
  }

  /** Warnings about its specification from the last check [SE-5]. */
  get warnings(): readonly SessionProblem[] {
    return this.#warnings;
  }

  get life(): SessionLife {
    return this.#life;
  }

  /** When it came to that state, monotonic milliseconds. */
  get lifeSinceMs(): number {
    return this.#lifeSinceMs;
  }

  /** The master started it at startup, and no user since. Only users stop it [SE-24]. */
  get isRestored(): boolean {
    return this.#isRestored;
  }

  /** Another master runs it now: the stored state belongs to that master. [CU-34] */
  get isGivenUp(): boolean {
    return this.#isGivenUp;
  }

  get isLive(): boolean {
    return isLive(this.#life);
  }

  get isPaused(): boolean {
    return this.#life === 'paused';
  }

  /** Its name, or its id when it has none, for messages. */
  get label(): string {
    const { name } = this.#description;
    return name === '' ? this.id : name;
  }

  /** Changes the state. Returns false when the event means nothing in the current one [SE-10]. */
  handle(event: SessionEvent, nowMs: number): boolean {
    const life = nextLife(this.#life, event);
    if (life === this.#life) return false;
    this.#life = life;
    this.#lifeSinceMs = nowMs;
    if (event === 'start') this.#hasRun = false;
    if (event === 'stop') this.#isRestored = false;
    if (event === 'start' || event === 'stop') this.troubles.clear();
    return true;
  }

  /** Records that all modules run. Returns true the first time since the start [SE-12]. */
  recordRun(): boolean {
    const isFirst = !this.#hasRun;
    this.#hasRun = true;
    return isFirst;
  }

  /** Marks it as started by the master at startup [SE-24]. */
  markRestored(): void {
    this.#isRestored = true;
  }

  /** Ends it here, because another master runs it. [CU-34] */
  giveUp(): void {
    this.#isGivenUp = true;
    this.#life = 'stopped';
  }

  /**
   * Replaces the specification [SE-15]. The new modules are not placed yet.
   *
   * @param isBeingStored it is stored under its new name; otherwise a renamed session is not stored any more
   * @returns the modules before
   */
  replace(content: SessionContent, isBeingStored: boolean): readonly SessionModule[] {
    const before = this.#modules;
    const description = describe(content.message);
    if (!isBeingStored) this.#isStored &&= description.name === this.#description.name;
    this.#description = description;
    this.#modules = content.modules.map((module) => new SessionModule(module));
    this.#byteLength = content.byteLength;
    this.#warnings = content.warnings ?? [];
    for (const grantId of content.grantIds) this.#grantIds.add(grantId);
    this.#revision++;
    return before;
  }

  /** Removes a grant [AC-92]. Returns false when the session does not have it. */
  removeGrant(grantId: GrantId): boolean {
    return this.#grantIds.delete(grantId);
  }

  /** Returns whether that changed something. */
  setStored(isStored: boolean): boolean {
    if (this.#isStored === isStored) return false;
    this.#isStored = isStored;
    return true;
  }

  /** Returns whether that changed something. */
  setWarnings(warnings: readonly SessionProblem[]): boolean {
    if (isSameValue(warnings, this.#warnings)) return false;
    this.#warnings = warnings;
    return true;
  }

  module(id: string): SessionModule | undefined {
    return this.#modules.find((module) => module.id === id);
  }

  modulesOn(nodeId: string): SessionModule[] {
    return this.#modules.filter((module) => module.nodeId === nodeId);
  }

  /** Reported memory of its modules on a node, bytes; a module that is being created counts with its minimum. */
  memoryOn(nodeId: string): number {
    return this.modulesOn(nodeId).reduce((sum, { memoryBytes }) => sum + memoryBytes, 0);
  }

  /** Topics that outputs are mapped to; those of demuxers show only when they run. */
  outputTopics(): Set<string> {
    return new Set(
      this.#modules.flatMap(({ mapping }) =>
        mapping.outputMappings.flatMap(({ topic }) => topic || []),
      ),
    );
  }

  /** Lists the current problems, errors first. */
  problems(): SessionProblem[] {
    const ofModules = this.#modules.flatMap(({ problem }) => problem ?? []);
    return sortProblems([...ofModules, ...this.troubles.values(), ...this.#warnings]);
  }

  /** The session on the wire. */
  toMessage(): SessionMessage {
    const { name, tags, description, authors, editable } = this.#description;
    const { startWithMaster, lockstepHertz, editorJson } = this.#description;
    return {
      id: this.id,
      name,
      processingModules: this.#modules.map((module) => module.toMessage(this.id, this.isPaused)),
      ioMappings: this.#modules.map((module) => module.mapping),
      tags: [...tags],
      description,
      authors: [...authors],
      status: wireStatus(this.#life),
      editable,
      extension: {
        state: wireState(this.#life),
        problems: this.problems(),
        startWithMaster,
        lockstepHertz,
        editorJson,
        revision: this.#revision,
        stored: this.#isStored,
        grantIds: [...this.#grantIds],
        masterId: this.masterId ?? '',
        movedFrom: this.move?.from ?? '',
        movedMs: this.move?.atMs ?? 0,
      },
    };
  }
}

function describe(message: SessionMessage): SessionDescription {
  const { name, tags, description, authors, editable, extension } = message;
  return {
    name,
    tags,
    description,
    authors,
    editable,
    startWithMaster: extension?.startWithMaster ?? false,
    lockstepHertz: extension?.lockstepHertz ?? 0,
    editorJson: extension?.editorJson ?? '',
  };
}
