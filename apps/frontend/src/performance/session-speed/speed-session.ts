import type { Init, ProcessingModule, Session } from '@ubii/proto';
import { TEST_SESSION_TAG } from '../run/test-session.ts';
import { processingMode, type SpeedParameters } from './speed-parameters.ts';

/** Topics of a test, below the id of the measuring client. */
export interface SpeedTopics {
  readonly stamp: string;
  readonly echo: string;
  readonly duration: string;
}

export function speedTopics(clientId: string): SpeedTopics {
  const topic = (name: string): string => `/${clientId}/performance/${name}`;
  return { stamp: topic('stamp'), echo: topic('echo'), duration: topic('duration') };
}

/**
 * Creates the temporary session with several load generators on one node. The outputs of the first one are measured.
 */
export function speedSession(
  parameters: SpeedParameters,
  {
    ownerId,
    nodeId,
    topics,
    module,
    uuid,
  }: {
    /** Id of the page's client. */
    readonly ownerId: string;
    readonly nodeId: string;
    readonly topics: SpeedTopics;
    /** The load generator with its code, so that any node can run it. */
    readonly module: Init<ProcessingModule>;
    readonly uuid: () => string;
  },
): Init<Session> {
  const ids = Array.from({ length: parameters.instances }, uuid);
  const name = module.name ?? '';
  return {
    name: 'Session speed test',
    description: 'A temporary session of the performance page. It is removed after the test.',
    tags: [TEST_SESSION_TAG, ownerId],
    processingModules: ids.map((id) => ({
      ...module,
      id,
      nodeId,
      processingMode: processingMode(parameters),
    })),
    ioMappings: ids.map((id, index) => ({
      processingModuleId: id,
      processingModuleName: name,
      inputMappings: [
        { inputName: 'iterations', constantJson: JSON.stringify({ int32: parameters.iterations }) },
        { inputName: 'stamp', topic: topics.stamp },
      ],
      outputMappings:
        index > 0
          ? []
          : [
              { outputName: 'durationMs', topic: topics.duration },
              { outputName: 'echo', topic: topics.echo },
            ],
    })),
  };
}
