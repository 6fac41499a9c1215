import type { Init, Session } from '@ubii/proto';

/** Modules of the library that find something in pictures, by what they find. */
export const SEEING_MODULES = {
  objects: { module: 'object-detection', output: 'predictions' },
  bodies: { module: 'body-pose', output: 'keypoints' },
  hands: { module: 'hand-pose', output: 'keypoints' },
} as const;

export type Seen = keyof typeof SEEING_MODULES;

/** A session that looks at the pictures of a topic. */
export interface SeeingSpec {
  readonly name: string;
  readonly description: string;
  readonly tags: readonly string[];
  /** Topic of the pictures. */
  readonly image: string;
  /** Where what is found goes, by what is looked for. */
  readonly found: { readonly [S in Seen]?: string | undefined };
  /** Topics of other inputs and outputs of `object-detection`, by their names. */
  readonly inputs?: { readonly [input: string]: string | undefined };
  readonly outputs?: { readonly [output: string]: string | undefined };
  /** Values of inputs of all modules, such as `{ double: 30 }`, by their names. */
  readonly constants?: { readonly [input: string]: object };
}

/** The session that other programs would make of it: pictures in, boxes and keypoints out. */
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
