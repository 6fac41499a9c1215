import { hasSameCode } from '@ubii/pm-sandbox';
import {
  isSameValue,
  ServiceError,
  type ProcessingModule,
  type Session as SessionMessage,
} from '@ubii/proto';
import type { Cancel } from '@ubii/timing';
import type { ModuleLibrary } from '../library/module-library.ts';
import { quote } from '../texts/quote.ts';
import { warningProblem } from './problems.ts';
import type { SessionNews } from './session-news.ts';
import type { Session } from './session.ts';
import type { SessionModule } from './session-module.ts';
import type { Sessions } from './sessions.ts';

/** Dependencies of reloading. */
export interface ReloadContext {
  readonly library: ModuleLibrary;
  readonly sessions: Sessions;
  readonly news: SessionNews;
}

/**
 * Updates the sessions that have the previous version of a stored module, after it was saved or its file
 * was changed. Changes made in the session itself stay. [SE-26]
 */
export class ModuleReload {
  readonly #context: ReloadContext;
  readonly #cancel: Cancel;
  #known: ReadonlyMap<string, ProcessingModule>;
  /** Modules of sessions that could not take a newer one, with the stored one they still are. */
  readonly #behind = new Map<string, ProcessingModule>();
  /** One after the other: each is an update of the sessions as they are then. */
  #work: Promise<void> = Promise.resolve();

  constructor(context: ReloadContext) {
    this.#context = context;
    this.#known = this.#stored();
    this.#cancel = context.library.stored.store.onChange(() => this.look());
  }

  /** Finds what has changed since it looked last. */
  look(): void {
    const before = this.#known;
    this.#known = this.#stored();
    for (const [name, now] of this.#known) {
      const old = before.get(name);
      if (old === undefined || old === now || isSameValue(old, now)) continue;
      // The operator's module of that name is the one that counts [PM-64]
      if (this.#context.library.get(name)?.isTrusted !== false) continue;
      this.#work = this.#work.then(() => this.#reload(old, now));
    }
  }

  close(): void {
    this.#cancel();
  }

  #stored(): ReadonlyMap<string, ProcessingModule> {
    const { stored } = this.#context.library;
    return new Map([...stored.list()].map(([name, { message }]) => [name, message]));
  }

  async #reload(old: ProcessingModule, now: ProcessingModule): Promise<void> {
    for (const session of this.#context.sessions.list()) {
      const users = session.modules
        .map((module) => ({ module, was: this.#behind.get(module.id) ?? old }))
        .filter(({ module, was }) => isUnchanged(module, was));
      if (users.length > 0) await this.#update(session, users, now);
    }
  }

  async #update(session: Session, users: readonly User[], now: ProcessingModule): Promise<void> {
    const message = session.toMessage();
    const processingModules = message.processingModules.map((spec) => {
      const user = users.find(({ module }) => module.id === spec.id);
      return user ? replaced(spec, user.was, now) : spec;
    });
    const key = `reload ${now.name}`;
    try {
      const next: SessionMessage = { ...message, processingModules };
      await this.#context.sessions.update(session, next, undefined);
      for (const { module } of users) this.#behind.delete(module.id);
      if (session.troubles.delete(key)) this.#context.news.announceChange(session);
    } catch (error) {
      // Removed meanwhile: there is no session to notify
      if (!(error instanceof ServiceError) || error.code === 'not_found') return;
      for (const { module, was } of users) this.#behind.set(module.id, was);
      const problem = warningProblem({
        code: 'module_not_reloaded',
        message: `The module ${quote(now.name)} was saved, but the session still runs the previous version: ${error.message}`,
        moduleName: now.name,
        moduleId: users[0]!.module.id,
      });
      session.troubles.set(key, problem);
      this.#context.news.announceChange(session);
    }
  }
}

/** A module of a session, and the stored one it still is. */
interface User {
  readonly module: SessionModule;
  readonly was: ProcessingModule;
}

/** Whether it is the stored one, as it was. */
function isUnchanged({ spec, isTrusted }: SessionModule, old: ProcessingModule): boolean {
  return !isTrusted && spec.name === old.name && hasSameCode(spec, old);
}

/** The module of a session with what has changed; a mode the session chose itself stays. */
function replaced(
  module: ProcessingModule,
  old: ProcessingModule,
  now: ProcessingModule,
): ProcessingModule {
  const isOwnMode = !isSameValue(module.processingMode, old.processingMode);
  const { version = '', libraries = [], assets = [], optionalAssets = [] } = now.extension ?? {};
  return {
    ...module,
    authors: now.authors,
    tags: now.tags,
    description: now.description,
    inputs: now.inputs,
    outputs: now.outputs,
    processingMode: isOwnMode ? module.processingMode : now.processingMode,
    onCreatedStringified: now.onCreatedStringified,
    onProcessingStringified: now.onProcessingStringified,
    onHaltedStringified: now.onHaltedStringified,
    onDestroyedStringified: now.onDestroyedStringified,
    extension: {
      grantIds: [],
      origin: module.extension?.origin ?? 0,
      replaceable: module.extension?.replaceable ?? false,
      version,
      libraries,
      assets,
      optionalAssets,
    },
  };
}
