import type { JsonObject } from '@ubii/proto';
import { isJsonObject } from './json-object.ts';
import type { OriginalFile } from './original-files.ts';

/** Modules of an original installation that have the name of a trusted module of this master. */
export class ShadowedModules {
  readonly #byName = new Map<string, JsonObject>();

  /** @param library trusted modules of this master, which come first [PM-64] */
  constructor(modules: readonly OriginalFile[], library: { has(name: string): boolean }) {
    for (const { document } of modules) {
      const { json } = document;
      const name = isJsonObject(json) ? json['name'] : undefined;
      if (typeof name === 'string' && library.has(name)) this.#byName.set(name, json as JsonObject);
    }
  }

  get names(): readonly string[] {
    return [...this.#byName.keys()];
  }

  /** The session, with the code of these modules where it names one: code in a session comes first. [SE-28] */
  addTo(session: OriginalFile): OriginalFile {
    const { json } = session.document;
    if (!isJsonObject(json) || !Array.isArray(json['processingModules'])) return session;
    const processingModules = (json['processingModules'] as unknown[]).map((module) =>
      isJsonObject(module) ? this.#complete(module) : module,
    );
    return { ...session, document: { json: { ...json, processingModules } } };
  }

  #complete(module: JsonObject): JsonObject {
    const own = this.#byName.get(String(module['name']));
    if (own === undefined || isGiven(module['onProcessingStringified'])) return module;
    const given = Object.entries(module).filter(([, value]) => isGiven(value));
    return { ...own, ...Object.fromEntries(given) } as JsonObject;
  }
}

function isGiven(value: unknown): boolean {
  return Array.isArray(value) ? value.length > 0 : Boolean(value);
}
