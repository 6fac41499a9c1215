import {
  encode,
  fromJson,
  isSameValue,
  ModuleVersionOrigin,
  toJson,
  type JsonObject,
  type ModuleVersion,
  type ProcessingModule,
} from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import type { DocumentStore } from '../ports/document-store.ts';
import type { Log } from '../ports/log.ts';

/** Limits of one history, and of all histories [EX-43]. */
const BOUNDS = { versions: 50, bytes: 2 * 1024 * 1024, histories: 512, allBytes: 64 * 1024 * 1024 };
/** Versions of a module that are kept, however large they are. */
const ALWAYS_KEPT = 2;

/** A stored module by its name, or the module of a session by its id. */
export type HistoryKey = `module ${string}` | `instance ${string}`;

/** One version as it lies in its document. */
interface KeptVersion {
  readonly number: number;
  readonly timeMs: number;
  readonly origin: ModuleVersion['origin'];
  /** Of the encoded module, bytes. */
  readonly byteLength: number;
  readonly module: JsonObject;
}

/** Dependencies of the history of modules. */
export interface HistoryContext {
  readonly store: DocumentStore;
  readonly clock: Clock;
  readonly log: Log;
}

/** Earlier versions of modules, kept beside them [EX-40]. */
export class ModuleHistory {
  readonly #context: HistoryContext;
  /** One change after the other: each reads what the one before wrote. */
  #queue: Promise<void> = Promise.resolve();

  constructor(context: HistoryContext) {
    this.#context = context;
  }

  /** The versions of a module, newest first; undefined when it has no history. */
  list(key: HistoryKey): readonly ModuleVersion[] | undefined {
    const versions = this.#versions(key);
    if (versions === undefined || versions.length === 0) return undefined;
    return versions.map((version) => messageOf(version, undefined)).reverse();
  }

  /** One version with its module; undefined when it is not kept, or cannot be read. */
  get(key: HistoryKey, number: number): ModuleVersion | undefined {
    const version = this.#versions(key)?.find((one) => one.number === number);
    const module = version === undefined ? undefined : readModule(version.module);
    return version && module && messageOf(version, module);
  }

  /** Whether this is what the newest version has. */
  isNewest(key: HistoryKey, module: ProcessingModule): boolean {
    const newest = this.#versions(key)?.at(-1);
    const kept = newest === undefined ? undefined : readModule(newest.module);
    return kept !== undefined && isSame(kept, module);
  }

  /**
   * Adds a version of a changed module [EX-41]. Never rejects: an incomplete history must not prevent saving.
   * @param before The module before the change; undefined when it is new or not known.
   */
  record(
    key: HistoryKey,
    before: ProcessingModule | undefined,
    module: ProcessingModule,
    origin: ModuleVersion['origin'],
  ): Promise<void> {
    const done = this.#queue.then(() => this.#record(key, before, module, origin));
    this.#queue = done.catch((error: unknown) => {
      const reason = error instanceof Error ? error.message : String(error);
      this.#context.log.error('a version of a module could not be saved', {
        module: module.name,
        reason,
      });
    });
    return this.#queue;
  }

  async #record(
    key: HistoryKey,
    before: ProcessingModule | undefined,
    module: ProcessingModule,
    origin: ModuleVersion['origin'],
  ): Promise<void> {
    const { store, clock } = this.#context;
    if (store.documents().get(key)?.fault !== undefined) return; // [EX-42]
    const versions = [...(this.#versions(key) ?? [])];
    const add = (added: ProcessingModule, from: ModuleVersion['origin']): void => {
      const newest = versions.at(-1);
      const kept = newest === undefined ? undefined : readModule(newest.module);
      if (kept !== undefined && isSame(kept, added)) return;
      const plain = contentOf(added);
      versions.push({
        number: (newest?.number ?? 0) + 1,
        timeMs: clock.nowMs(),
        origin: from,
        byteLength: encode('ubii.processing.ProcessingModule', plain).byteLength,
        module: toJson('ubii.processing.ProcessingModule', plain),
      });
    };
    const length = versions.length;
    if (before !== undefined && length === 0) add(before, ModuleVersionOrigin.FOUND);
    add(module, origin);
    if (versions.length === length) return;
    await store.write(key, { versions: bounded(versions) as unknown as JsonObject[] });
    await this.#makeRoom(key);
  }

  /** Histories that were not touched for longest go, until the others fit [EX-43]. */
  async #makeRoom(key: HistoryKey): Promise<void> {
    const { store } = this.#context;
    const histories = [...store.documents().keys()].flatMap((other) => {
      const versions = this.#versions(other as HistoryKey);
      if (versions === undefined) return [];
      return [{ key: other, bytes: sum(versions), timeMs: versions.at(-1)?.timeMs ?? 0 }];
    });
    histories.sort((a, b) => a.timeMs - b.timeMs);
    let bytes = histories.reduce((total, one) => total + one.bytes, 0);
    let count = histories.length;
    for (const oldest of histories) {
      if (count <= BOUNDS.histories && bytes <= BOUNDS.allBytes) return;
      if (oldest.key === key) continue;
      await store.delete(oldest.key);
      bytes -= oldest.bytes;
      count--;
    }
  }

  /** Oldest first. What is no version is passed over. */
  #versions(key: HistoryKey): readonly KeptVersion[] | undefined {
    const json = this.#context.store.documents().get(key)?.json;
    const versions = (json as { versions?: unknown } | null | undefined)?.versions;
    return Array.isArray(versions) ? versions.filter(isKeptVersion) : undefined;
  }
}

/** As many of the newest as fit. */
function bounded(versions: readonly KeptVersion[]): readonly KeptVersion[] {
  let kept = versions.slice(-BOUNDS.versions);
  while (kept.length > ALWAYS_KEPT && sum(kept) > BOUNDS.bytes) kept = kept.slice(1);
  return kept;
}

function sum(versions: readonly KeptVersion[]): number {
  return versions.reduce((total, { byteLength }) => total + byteLength, 0);
}

function messageOf(version: KeptVersion, module: ProcessingModule | undefined): ModuleVersion {
  const { number, timeMs, origin, byteLength } = version;
  const extension = version.module['extension'] as { version?: unknown } | undefined;
  const name = extension?.version;
  return {
    number,
    timeMs,
    origin,
    byteLength,
    version: typeof name === 'string' ? name : '',
    current: false,
    module,
  };
}

function readModule(json: JsonObject): ProcessingModule | undefined {
  try {
    return fromJson('ubii.processing.ProcessingModule', json);
  } catch {
    return undefined;
  }
}

/** Whether two modules are the same, wherever they are and run. */
export function isSame(a: ProcessingModule, b: ProcessingModule): boolean {
  const plain = (module: ProcessingModule): JsonObject =>
    toJson('ubii.processing.ProcessingModule', contentOf(module));
  return isSameValue(plain(a), plain(b));
}

/** Returns the stored part of a module, without its place and state. */
function contentOf(module: ProcessingModule): ProcessingModule {
  const { version = '', libraries = [], assets = [], optionalAssets = [] } = module.extension ?? {};
  const isBare = version === '' && libraries.length + assets.length + optionalAssets.length === 0;
  return {
    ...module,
    id: '',
    nodeId: '',
    sessionId: '',
    status: 0,
    extension: isBare
      ? undefined
      : { version, libraries, assets, optionalAssets, replaceable: false, origin: 0, grantIds: [] },
  };
}

function isKeptVersion(value: unknown): value is KeptVersion {
  const one = value as Partial<KeptVersion> | null;
  return (
    typeof one === 'object' &&
    one !== null &&
    typeof one.number === 'number' &&
    typeof one.timeMs === 'number' &&
    typeof one.origin === 'number' &&
    typeof one.byteLength === 'number' &&
    typeof one.module === 'object' &&
    one.module !== null
  );
}
