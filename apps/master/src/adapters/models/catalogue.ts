import type { AssetFile } from '@ubii/pm-sandbox';

/** A model that can be downloaded: an asset set with the sizes and hashes that its publisher's files have. */
export interface KnownModel {
  /** Name of the asset set. */
  readonly name: string;
  readonly description: string;
  readonly version: string;
  /** SPDX expression. */
  readonly licence: string;
  /** Page of the publisher, for people. */
  readonly source: string;
  /** URL of the folder with the files, with a trailing slash. */
  readonly address: string;
  readonly files: readonly AssetFile[];
}

/** Models that modules of the library can use, and that do not come with the program. [EX-58] */
export const KNOWN_MODELS: readonly KnownModel[] = [
  {
    name: 'coco-ssd',
    description: 'COCO-SSD, a detector of 80 classes of objects, for the module object-detection.',
    version: 'ssdlite_mobilenet_v2',
    licence: 'Apache-2.0',
    source: 'https://github.com/tensorflow/tfjs-models/tree/master/coco-ssd',
    address: 'https://storage.googleapis.com/tfjs-models/savedmodel/ssdlite_mobilenet_v2/',
    files: [
      {
        path: 'model.json',
        bytes: 527_315,
        sha256: '3770b2528339b1e3340cb74360e1e40401816b009779aeb8d0cce3a4353ea3a9',
      },
      {
        path: 'group1-shard1of5',
        bytes: 4_194_304,
        sha256: '0e7af0f713e98521252321f7f84892c31cefccccec3ac64c84e5065b75ed5646',
      },
      {
        path: 'group1-shard2of5',
        bytes: 4_194_304,
        sha256: '74cc6cfc2c4510c9cd81b8ad4cebf6f6a8f305119bb365ce0eb96276da38519a',
      },
      {
        path: 'group1-shard3of5',
        bytes: 4_194_304,
        sha256: '50383033f893eae136392a403e8f70ade5efd90867df5695c4ca5ac640e14f38',
      },
      {
        path: 'group1-shard4of5',
        bytes: 4_194_304,
        sha256: 'd856dc534c780068bbf6c666ce1516df2c8433d87578aa31fcdf197de7058cc2',
      },
      {
        path: 'group1-shard5of5',
        bytes: 1_257_312,
        sha256: '3d356f1fb6dfca6af78c56db34d9326706d0196e303f9de6b04f236ca79ed309',
      },
    ],
  },
];

/** Bytes of all files of a model. */
export function modelBytes({ files }: Pick<KnownModel, 'files'>): number {
  return files.reduce((sum, { bytes }) => sum + bytes, 0);
}

/**
 * Returns the URL of a model's files: at its publisher, or in the folder of its name on a mirror.
 *
 * @returns the address of the folder, with a slash at the end
 */
export function modelAddress({ name, address }: KnownModel, mirror: string | undefined): string {
  return mirror === undefined ? address : new URL(`${name}/`, mirror).href;
}
