import { ModuleOrigin, ServiceError, toJson, type ProcessingModule } from '@ubii/proto';
import type { GrantId } from '../access/grant.ts';
import { quote } from '../texts/quote.ts';
import { NO_LANGUAGE, type ModuleOffer } from './module-offer.ts';
import type { StoredMessages } from './stored-messages.ts';

/** Modules the master has: those of the program and of its operator, and stored ones [SE-22]. */
export class ModuleLibrary {
  readonly #trusted: () => readonly ProcessingModule[];
  readonly stored: StoredMessages<'ubii.processing.ProcessingModule'>;

  /** The list, and what it was made of. */
  #listed:
    | {
        readonly trusted: readonly ProcessingModule[];
        readonly documents: unknown;
        readonly modules: readonly ProcessingModule[];
      }
    | undefined = undefined;

  constructor(
    trusted: () => readonly ProcessingModule[],
    stored: StoredMessages<'ubii.processing.ProcessingModule'>,
  ) {
    this.#trusted = trusted;
    this.stored = stored;
  }

  /** Of two with one name, the operator's counts [PM-64]. */
  get(name: string): ModuleOffer | undefined {
    if (name === '') return undefined;
    const trusted = this.#trusted().find((module) => module.name === name);
    if (trusted !== undefined) return { module: trusted, isTrusted: true };
    const module = this.stored.get(name);
    return module === undefined ? undefined : { module, isTrusted: false };
  }

  /** Each says where it is from [SE-22]. The same list as long as nothing changes. */
  list(): readonly ProcessingModule[] {
    const trusted = this.#trusted();
    const documents = this.stored.store.documents();
    if (this.#listed?.trusted === trusted && this.#listed.documents === documents) {
      return this.#listed.modules;
    }
    const names = new Set(trusted.map(({ name }) => name));
    const stored = [...this.stored.list().values()].map(({ message }) =>
      withOrigin(message, ModuleOrigin.MODULE_ORIGIN_STORED),
    );
    const modules = [...trusted, ...stored.filter(({ name }) => !names.has(name))];
    this.#listed = { trusted, documents, modules };
    return modules;
  }

  isStored(name: string): boolean {
    return this.stored.get(name) !== undefined;
  }

  /** Names of the stored ones that clients of a grant made or changed [AC-90]. */
  madeWith(grantId: GrantId): string[] {
    return [...this.stored.list().values()]
      .filter(({ message }) => message.extension?.grantIds.includes(grantId))
      .map(({ message }) => message.name);
  }

  /** Stored modules are no longer those of a grant [AC-92]. */
  async handOver(grantId: GrantId): Promise<void> {
    for (const name of this.madeWith(grantId)) {
      const module = this.stored.get(name)!;
      const grantIds = grantIdsOf(module).filter((id) => id !== grantId);
      const json = toJson('ubii.processing.ProcessingModule', withGrants(module, grantIds));
      await this.stored.store.write(this.stored.keyOf(name), json);
    }
  }

  /**
   * @param maker grant of the client that saves it; undefined for callers without one [AC-90]
   * @throws ServiceError when the module may not be changed.
   */
  async save(module: ProcessingModule, maker: GrantId | undefined): Promise<ProcessingModule> {
    this.#requireStorable(module.name);
    const before = this.stored.get(module.name);
    const makers = new Set([...grantIdsOf(before), ...(maker === undefined ? [] : [maker])]);
    const stored = withGrants(storable(module), [...makers]);
    const json = toJson('ubii.processing.ProcessingModule', stored);
    await this.stored.store.write(this.stored.keyOf(module.name), json);
    return withOrigin(this.stored.get(module.name) ?? stored, ModuleOrigin.MODULE_ORIGIN_STORED);
  }

  /** @throws ServiceError when there is none, or it may not be deleted. */
  async delete(name: string): Promise<void> {
    this.#requireStorable(name);
    if (!this.isStored(name)) throw unknownModule(name);
    await this.stored.store.delete(this.stored.keyOf(name));
  }

  #requireStorable(name: string): void {
    if (!this.#trusted().some((module) => module.name === name)) return;
    throw new ServiceError(
      'failed_precondition', // [SE-22]
      `The module ${quote(name)} belongs to the program or to the folder of its operator and cannot be changed here. Save a copy under another name.`,
    );
  }
}

/** The module, with where it is from. */
export function withOrigin(module: ProcessingModule, origin: ModuleOrigin): ProcessingModule {
  const { version = '', grantIds = [] } = module.extension ?? {};
  const { libraries = [], assets = [], optionalAssets = [] } = module.extension ?? {};
  return {
    ...module,
    extension: {
      version,
      libraries,
      assets,
      optionalAssets,
      replaceable: false,
      origin,
      grantIds,
    },
  };
}

function withGrants(module: ProcessingModule, grantIds: string[]): ProcessingModule {
  return { ...withOrigin(module, 0), extension: { ...withOrigin(module, 0).extension!, grantIds } };
}

function grantIdsOf(module: ProcessingModule | undefined): readonly string[] {
  return module?.extension?.grantIds ?? [];
}

export function unknownModule(name: string): ServiceError {
  return new ServiceError(
    'not_found',
    `No module is named ${quote(name)}; /services/processing_module/database/get_list lists those there are.`,
  );
}

/** Returns the stored part of a module, without that of an instance. */
function storable(module: ProcessingModule): ProcessingModule {
  return {
    ...module,
    id: '',
    nodeId: '',
    sessionId: '',
    status: 0,
    language: module.language || NO_LANGUAGE,
  };
}
