import type { DataFormat, Session } from '@ubii/proto';
import { DATA_FORMATS, fromJson } from '@ubii/proto';
import type { IoInit } from '@ubii/pm-sandbox';
import { expect } from 'vitest';
import { MODULES } from '../src/index.ts';
import { formatOf, isList } from './drive-module.ts';

/** Expects a session to name modules of the library, their inputs and outputs, and constants that fit. */
export function expectKnownNames(session: Session): void {
  expect(session.name).not.toBe('');
  expect(session.ioMappings.map((mapping) => mapping.processingModuleName)).toEqual(
    session.processingModules.map(({ name }) => name),
  );
  for (const mapping of session.ioMappings) {
    const module = MODULES.find(({ name }) => name === mapping.processingModuleName);
    expect(module, mapping.processingModuleName).toBeDefined();
    const { inputs, outputs } = module as {
      inputs: Readonly<Record<string, IoInit>>;
      outputs: Readonly<Record<string, IoInit>>;
    };
    for (const { inputName, topicMux, constantJson } of mapping.inputMappings) {
      const input = inputs[inputName]!;
      expect(input, inputName).toBeDefined();
      expect(isList(input), inputName).toBe(topicMux !== undefined);
      if (constantJson !== '') expectConstant(formatOf(input), constantJson);
    }
    for (const { outputName, topicDemux } of mapping.outputMappings) {
      const output = outputs[outputName]!;
      expect(output, outputName).toBeDefined();
      expect(isList(output), outputName).toBe(topicDemux !== undefined);
    }
  }
}

function expectConstant(format: DataFormat, json: string): void {
  const constant: unknown = JSON.parse(json);
  expect(Object.keys(constant as object)).toEqual([format]);
  const record = fromJson('ubii.topicData.TopicDataRecord', constant);
  expect(DATA_FORMATS[format].validate(record[format])).toBeUndefined();
}
