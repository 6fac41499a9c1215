import { fromJson, type NodeInfo } from '@ubii/proto';
import { expect, it } from 'vitest';
import { recorderOptions } from './recorders.ts';

const aNode = (clientId: string, records: boolean, available = true): NodeInfo =>
  fromJson('ubii.extension.NodeInfo', {
    clientId,
    available,
    name: `${clientId} node`,
    node: { records },
  });

it('[RC-60] the master records, or a node that offers it and is there', () => {
  const nodes = [aNode('kitchen', true), aNode('desk', false), aNode('hall', true, false)];
  expect(recorderOptions(nodes)).toEqual([
    { value: 'master', text: 'This master' },
    { value: 'kitchen', text: 'kitchen node' },
  ]);
});
