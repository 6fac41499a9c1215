import { describe, expect, it } from 'vitest';
import { TestMaster } from '../src/testing/index.ts';

describe('publishing and subscribing', () => {
  it('reaches subscribers by topic and pattern, the publisher too, each once [TD-14]', async () => {
    const master = new TestMaster();
    const ada = await master.legacy('ada');
    const ben = await master.legacy('ben');
    await ada.subscribe({ subscribeTopics: ['/a'], subscribeTopicRegexp: ['^/a'] });
    await ben.subscribe({ subscribeTopicRegexp: ['^/a', '/b$', '.*'] });
    ada.publish('/a', 'double', 0.5);
    expect(ada.takeValues()).toEqual([['/a', 0.5]]);
    expect(ben.takeValues()).toEqual([['/a', 0.5]]);
  });
});
