import { constantRecord, formatsFit, hasPlaceholder, parseDemuxFormat } from '@ubii/pm-sandbox';
import {
  DATA_FORMATS,
  decodeRecord,
  isMasterTopic,
  parseDataFormat,
  type ModuleIO,
  type SessionProblem,
  type TopicDemux,
  type TopicInputMapping,
  type TopicMux,
  type TopicOutputMapping,
} from '@ubii/proto';
import { quote } from '../../texts/quote.ts';
import { topicFault } from '../../topics/topic-names.ts';
import type { DraftModule } from '../complete-modules.ts';
import { errorProblem, warningProblem } from '../problems.ts';
import { about, type Check, type CheckContext } from './check-context.ts';
import { hasCode, ioOf } from './check-modules.ts';

/** Each mapping by itself: names, expressions, topics, constants, lists [SE-4]. */
export const checkMappings: Check = function* (modules, context) {
  for (const draft of modules) {
    yield* checkInputs(draft, context);
    yield* checkOutputs(draft, context);
  }
};

function* checkInputs(draft: DraftModule, context: CheckContext): Iterable<SessionProblem> {
  const seen = new Set<string>();
  for (const [index, mapping] of draft.mapping.inputMappings.entries()) {
    const path = `${draft.mappingPath}.inputMappings[${index}]`;
    yield* checkIoName(draft, 'input', mapping.inputName, `${path}.inputName`);
    if (seen.has(mapping.inputName)) {
      yield errorProblem({
        ...about(draft),
        code: 'mapped_twice',
        message: `The input ${quote(mapping.inputName)} of ${quote(draft.spec.name)} is mapped twice; an input has one source.`,
        path,
      });
    }
    seen.add(mapping.inputName);
    const input = ioOf(draft.spec.inputs, mapping.inputName);
    yield* checkSource(draft, mapping, input, path, context);
  }
}

function* checkSource(
  draft: DraftModule,
  { topic, topicMux, constantJson, inputName }: TopicInputMapping,
  input: ModuleIO | undefined,
  path: string,
  context: CheckContext,
): Iterable<SessionProblem> {
  if (topicMux !== undefined) {
    yield* checkMux(draft, topicMux, input, `${path}.topicMux`, context);
    if (input !== undefined && saysWhatIsAList(draft) && !input.isRecordList) {
      yield errorProblem({
        ...about(draft),
        code: 'list_unexpected',
        message: `The input ${quote(inputName)} of ${quote(draft.spec.name)} expects single records, but is mapped to a muxer, which outputs lists. Map it to a topic.`,
        path: `${path}.topicMux`,
      });
    }
  } else if (topic !== undefined && topic !== '') {
    yield* checkTopicText(draft, topic, `${path}.topic`, context);
    if (input?.isRecordList === true) {
      yield errorProblem({
        ...about(draft),
        code: 'list_expected',
        message: `The input ${quote(inputName)} of ${quote(draft.spec.name)} expects lists of records, but is mapped to one topic. Map it to a muxer.`,
        path: `${path}.topic`,
      });
    }
  } else if (constantJson !== '') {
    const fault = constantFault(constantJson, input);
    if (fault !== undefined) {
      yield errorProblem({
        ...about(draft),
        code: 'bad_constant',
        message: `The input ${quote(inputName)} of ${quote(draft.spec.name)} cannot have this constant: ${fault.replace(/\.$/, '')}.`,
        path: `${path}.constantJson`,
      });
    }
  }
}

function* checkMux(
  draft: DraftModule,
  mux: TopicMux,
  input: ModuleIO | undefined,
  path: string,
  { patternFault }: CheckContext,
): Iterable<SessionProblem> {
  const isSelected = mux.component !== undefined || mux.topicGlob !== '';
  const expressions = [
    ...(isSelected ? [] : [['topicSelector', mux.topicSelector] as const]),
    ['identityMatchPattern', mux.identityMatchPattern] as const,
  ];
  for (const [member, source] of expressions) {
    const fault = source === '' ? undefined : patternFault(source);
    if (fault === undefined) continue;
    yield errorProblem({
      ...about(draft),
      code: 'bad_expression',
      message: `${quote(source)} is not a regular expression in RE2 syntax: ${fault}.`,
      path: `${path}.${member}`,
    });
  }
  if (!isSelected && mux.topicSelector === '') {
    yield errorProblem({
      ...about(draft),
      code: 'bad_expression',
      message: `The muxer ${quote(mux.name)} selects no topics. Give it a regular expression, a glob or a component profile.`,
      path: `${path}.topicSelector`,
    });
  }
  const format = parseDataFormat(mux.dataType);
  const declared = parseDataFormat(input?.messageFormat ?? '');
  if (!formatsFit(format, declared)) {
    yield errorProblem({
      ...about(draft),
      code: 'format_mismatch',
      message: `The muxer outputs ${format}, but the input ${quote(input?.internalName ?? '')} of ${quote(draft.spec.name)} expects ${declared}.`,
      path: `${path}.dataType`,
    });
  }
}

function* checkOutputs(draft: DraftModule, context: CheckContext): Iterable<SessionProblem> {
  for (const [index, mapping] of draft.mapping.outputMappings.entries()) {
    const path = `${draft.mappingPath}.outputMappings[${index}]`;
    yield* checkIoName(draft, 'output', mapping.outputName, `${path}.outputName`);
    const output = ioOf(draft.spec.outputs, mapping.outputName);
    yield* checkDestination(draft, mapping, output, path, context);
  }
}

function* checkDestination(
  draft: DraftModule,
  { topic, topicDemux, outputName }: TopicOutputMapping,
  output: ModuleIO | undefined,
  path: string,
  context: CheckContext,
): Iterable<SessionProblem> {
  if (topicDemux !== undefined) {
    yield* checkDemux(draft, topicDemux, output, `${path}.topicDemux`);
    if (output !== undefined && saysWhatIsAList(draft) && !output.isRecordList) {
      yield errorProblem({
        ...about(draft),
        code: 'list_expected',
        message: `The output ${quote(outputName)} of ${quote(draft.spec.name)} outputs single records, but is mapped to a demuxer, which expects lists. Map it to a topic.`,
        path: `${path}.topicDemux`,
      });
    }
  } else if (topic !== undefined && topic !== '') {
    yield* checkTopicText(draft, topic, `${path}.topic`, context);
    if (isMasterTopic(topic)) yield forbidden(draft, topic, `${path}.topic`);
    if (output?.isRecordList === true) {
      yield errorProblem({
        ...about(draft),
        code: 'list_unexpected',
        message: `The output ${quote(outputName)} of ${quote(draft.spec.name)} outputs lists of records, but is mapped to one topic. Map it to a demuxer.`,
        path: `${path}.topic`,
      });
    }
  }
}

function* checkDemux(
  draft: DraftModule,
  demux: TopicDemux,
  output: ModuleIO | undefined,
  path: string,
): Iterable<SessionProblem> {
  const { outputTopicFormat } = demux;
  if (!hasPlaceholder(parseDemuxFormat(outputTopicFormat))) {
    // [PM-45]
    yield errorProblem({
      ...about(draft),
      code: 'demux_without_placeholder',
      message: `The format ${quote(outputTopicFormat)} has no placeholder, so that all elements would go to one topic; put {{#0}}, {{identity}} or %s where they differ.`,
      path: `${path}.outputTopicFormat`,
    });
  }
  if (isMasterTopic(outputTopicFormat)) {
    yield forbidden(draft, outputTopicFormat, `${path}.outputTopicFormat`);
  }
  const format = parseDataFormat(demux.dataType);
  const declared = parseDataFormat(output?.messageFormat ?? '');
  if (!formatsFit(declared, format)) {
    yield errorProblem({
      ...about(draft),
      code: 'format_mismatch',
      message: `The output ${quote(output?.internalName ?? '')} of ${quote(draft.spec.name)} outputs ${declared}, but the demuxer expects ${format}.`,
      path: `${path}.dataType`,
    });
  }
}

function forbidden(draft: DraftModule, topic: string, path: string): SessionProblem {
  return errorProblem({
    ...about(draft),
    code: 'forbidden_topic',
    message: `Only the master publishes on ${quote(topic)}. Choose a topic that does not begin with /info/ or /ubii/.`,
    path,
  });
}

function* checkTopicText(
  draft: DraftModule,
  topic: string,
  path: string,
  { topicBytes }: CheckContext,
): Iterable<SessionProblem> {
  const fault = topicFault(topic, topicBytes);
  if (fault === undefined) return;
  yield errorProblem({
    ...about(draft),
    code: 'bad_topic',
    message: `${quote(topic)} cannot be a topic, because it ${fault}.`,
    path,
  });
}

function* checkIoName(
  draft: DraftModule,
  kind: 'input' | 'output',
  name: string,
  path: string,
): Iterable<SessionProblem> {
  const { spec } = draft;
  const declared = kind === 'input' ? spec.inputs : spec.outputs;
  if (ioOf(declared, name) !== undefined) return;
  const names = declared.map(({ internalName }) => internalName).join(', ');
  // The inputs and outputs of a node's own module are unknown if the node does not describe them. [SE-6]
  const isUnknown = !hasCode(draft) && spec.inputs.length === 0 && spec.outputs.length === 0;
  const problem = isUnknown ? warningProblem : errorProblem;
  yield problem({
    ...about(draft),
    code: kind === 'input' ? 'unknown_input' : 'unknown_output',
    message: `The module ${quote(spec.name)} has no ${kind} named ${quote(name)}. Its ${kind}s: ${names || 'none'}.`,
    path,
  });
}

/** `false` is also the default for an output: it counts only when another output of the module is a list. */
function saysWhatIsAList({ spec }: DraftModule): boolean {
  return [...spec.inputs, ...spec.outputs].some(({ isRecordList }) => isRecordList);
}

/** Why a constant is none; undefined when it is one [PM-34]. */
function constantFault(json: string, input: ModuleIO | undefined): string | undefined {
  const declared = parseDataFormat(input?.messageFormat ?? '');
  const constant = constantRecord(json, declared);
  if ('problem' in constant) return constant.problem;
  const { format, value } = decodeRecord(constant.bytes);
  const fault = format === undefined ? undefined : DATA_FORMATS[format].validate(value);
  return fault === undefined ? undefined : `the constant is not of the format ${format}: ${fault}`;
}
