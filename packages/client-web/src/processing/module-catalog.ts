import { ProcessingModuleLanguage, decode, encode } from '@ubii/proto';
import type { Init, ProcessingModule } from '@ubii/proto';
import { hasSameCode } from '@ubii/pm-sandbox';
import type { ModuleFault } from '@ubii/pm-sandbox';

/** A module that is ready to be made, or, with a fault, why it is not. */
export interface ResolvedModule {
  readonly module: ProcessingModule;
  readonly isTrusted: boolean;
  readonly fault?: ModuleFault;
}

/** The modules a node has code for. Its operator vouches for them. [PM-51] */
export class ModuleCatalog {
  readonly #byName = new Map<string, ProcessingModule>();

  /** @param modules of several with one name the last counts */
  constructor(modules: readonly Init<ProcessingModule>[]) {
    for (const module of modules) {
      const complete = decode(MODULE, encode(MODULE, module));
      this.#byName.set(complete.name, complete);
    }
  }

  /** Descriptions of the modules for the master: everything except their code. [PM-60] */
  offers(): Init<ProcessingModule>[] {
    return [...this.#byName.values()].map(
      ({ name, authors, tags, description, processingMode, inputs, outputs, extension }) => ({
        name,
        authors,
        tags,
        description,
        ...(processingMode === undefined ? {} : { processingMode }),
        inputs,
        outputs,
        language: ProcessingModuleLanguage.JS,
        ...(extension === undefined ? {} : { extension }),
      }),
    );
  }

  /** The module a session asks for, with its code. [PM-64] */
  resolve(asked: ProcessingModule): ResolvedModule {
    const own = this.#byName.get(asked.name);
    if (asked.onProcessingStringified !== '') {
      const fault = foreignLanguage(asked);
      if (fault !== undefined) return { module: asked, isTrusted: false, fault };
      return { module: asked, isTrusted: own !== undefined && hasSameCode(asked, own) };
    }
    if (own === undefined) {
      const message = `Neither the session nor this node has code of the module "${asked.name}"`;
      return { module: asked, isTrusted: false, fault: missing(message) };
    }
    return { module: withOwnCode(asked, own), isTrusted: true };
  }
}

const MODULE = 'ubii.processing.ProcessingModule';

/** Fields that the session leaves out keep the values of the module's author. */
function withOwnCode(asked: ProcessingModule, own: ProcessingModule): ProcessingModule {
  return {
    ...asked,
    language: ProcessingModuleLanguage.JS,
    onCreatedStringified: own.onCreatedStringified,
    onProcessingStringified: own.onProcessingStringified,
    onHaltedStringified: own.onHaltedStringified,
    onDestroyedStringified: own.onDestroyedStringified,
    inputs: asked.inputs.length > 0 ? asked.inputs : own.inputs,
    outputs: asked.outputs.length > 0 ? asked.outputs : own.outputs,
    processingMode: asked.processingMode ?? own.processingMode,
    extension: own.extension ?? asked.extension,
  };
}

/** No language, which cannot be told from C++, means JavaScript. */
function foreignLanguage({ language, name }: ProcessingModule): ModuleFault | undefined {
  if (language === ProcessingModuleLanguage.JS || language === ProcessingModuleLanguage.CPP) {
    return undefined;
  }
  const [known] = Object.entries(ProcessingModuleLanguage).find(([, n]) => n === language) ?? [];
  return missing(
    `The code of the module "${name}" is written in ${known ?? 'another language'}; this node runs JavaScript`,
  );
}

function missing(message: string): ModuleFault {
  return { kind: 'missing', phase: '', message };
}
