import type { io } from '@tensorflow/tfjs-core';
import type { Files } from './memory-platform.ts';

/** `model.json` of a TensorFlow.js graph model, as far as it is read here. */
interface GraphModelFile {
  readonly format?: string;
  readonly modelTopology: io.ModelJSON['modelTopology'];
  readonly signature?: io.ModelJSON['signature'];
  readonly weightsManifest: readonly {
    readonly paths: readonly string[];
    readonly weights: io.WeightsManifestEntry[];
  }[];
}

/** Bytes of a stored number. */
const BYTES: Readonly<Record<string, number>> = {
  bool: 1,
  uint8: 1,
  uint16: 2,
  float16: 2,
  int32: 4,
  float32: 4,
  complex64: 8,
};

/**
 * Reads a graph model out of files in memory.
 *
 * @param files with the model's `.json` and the weights it names
 * @param modelName name of the `.json`
 * @throws Error that names the file that is missing or damaged
 */
export function readModelFiles(files: Files, modelName: string): io.ModelArtifacts {
  const model = parseModel(fileOf(files, modelName, modelName), modelName);
  const weightSpecs = model.weightsManifest.flatMap(({ weights }) => weights);
  const parts = model.weightsManifest.flatMap(({ paths }) =>
    paths.map((path) => fileOf(files, path, modelName)),
  );
  const found = parts.reduce((sum, { byteLength }) => sum + byteLength, 0);
  const expected = weightSpecs.reduce((sum, spec) => sum + bytesOf(spec, modelName), 0);
  if (found !== expected) {
    throw new Error(
      `The weights of "${modelName}" have ${found} bytes instead of ${expected}. Download the model again.`,
    );
  }
  const weightData = new Uint8Array(found);
  let at = 0;
  for (const part of parts) {
    weightData.set(part, at);
    at += part.byteLength;
  }
  return {
    format: 'graph-model',
    modelTopology: model.modelTopology,
    signature: model.signature,
    weightSpecs,
    weightData: weightData.buffer,
  };
}

function fileOf(files: Files, path: string, modelName: string): Uint8Array {
  const bytes = files[path];
  if (bytes === undefined) {
    throw new Error(`The file "${path}" of the model "${modelName}" is missing.`);
  }
  return bytes;
}

function parseModel(bytes: Uint8Array, modelName: string): GraphModelFile {
  let model: Partial<GraphModelFile> | null;
  try {
    model = JSON.parse(new TextDecoder().decode(bytes)) as Partial<GraphModelFile> | null;
  } catch {
    throw new Error(`"${modelName}" is not valid JSON. Download the model again.`);
  }
  if (
    typeof model?.modelTopology !== 'object' ||
    !Array.isArray(model.weightsManifest) ||
    (model.format ?? 'graph-model') !== 'graph-model'
  ) {
    throw new Error(`"${modelName}" is not a graph model of TensorFlow.js.`);
  }
  return model as GraphModelFile;
}

function bytesOf(spec: io.WeightsManifestEntry, modelName: string): number {
  const bytes = BYTES[spec.quantization?.dtype ?? spec.dtype];
  if (bytes === undefined) {
    throw new Error(
      `"${modelName}" has weights of the type ${spec.dtype}, which is not supported.`,
    );
  }
  return spec.shape.reduce((product, length) => product * length, bytes);
}
