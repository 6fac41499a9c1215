import type { Init, Session } from '@ubii/proto';

/** Library modules that analyse pictures, by their results. */
export const SEEING_MODULES = {
  objects: { module: 'object-detection', output: 'predictions' },
  bodies: { module: 'body-pose', output: 'keypoints' },
  hands: { module: 'hand-pose', output: 'keypoints' },
} as const;

export type Seen = keyof typeof SEEING_MODULES;

/** Specification of a session that analyses the pictures of a topic. */
export interface SeeingSpec {
  readonly name: string;
  readonly description: string;
  readonly tags: readonly string[];
  /** Topic of the pictures. */
  readonly image: string;
  /** Topics of the results. */
  readonly found: { readonly [S in Seen]?: string | undefined };
  /** Topics of other inputs and outputs of `object-detection`, by name. */
  readonly inputs?: { readonly [input: string]: string | undefined };
  readonly outputs?: { readonly [output: string]: string | undefined };
  /** Constants for inputs of all modules, such as `{ double: 30 }`, by input name. */
  readonly constants?: { readonly [input: string]: object };
}

/** Creates a session that reads pictures and writes boxes and keypoints, as existing programs do. */
export function seeingSession(spec: SeeingSpec): Init<Session> {
  const seen = (Object.keys(SEEING_MODULES) as Seen[]).filter((one) => spec.found[one]);
  const toTopics = (topics: { readonly [name: string]: string | undefined } = {}) =>
    Object.entries(topics).flatMap(([name, topic]) => (topic ? [{ name, topic }] : []));
  return {
    name: spec.name,
    description: spec.description,
    tags: [...spec.tags],
    processingModules: seen.map((one) => ({ name: SEEING_MODULES[one].module })),
    ioMappings: seen.map((one) => {
      const { module, output } = SEEING_MODULES[one];
      const inputs = { image: spec.image, ...(one === 'objects' && spec.inputs) };
      const outputs = { [output]: spec.found[one], ...(one === 'objects' && spec.outputs) };
      return {
        processingModuleName: module,
        inputMappings: [
          ...toTopics(inputs).map(({ name, topic }) => ({ inputName: name, topic })),
          ...Object.entries(spec.constants ?? {}).map(([name, value]) => ({
            inputName: name,
            constantJson: JSON.stringify(value),
          })),
        ],
        outputMappings: toTopics(outputs).map(({ name, topic }) => ({ outputName: name, topic })),
      };
    }),
  };
}
