import { SHARING_RULES } from '@ubii/recording/personal';
import { describe, expect, it } from 'vitest';
import { exportableTopics, formatHint, formatRefusal, topicOption } from './export-choice.ts';
import { exportName, topicFileNames } from './export-names.ts';
import { evenSize } from './video-format.ts';

const topic = (name: string, format: string) => ({
  topic: name,
  clientId: '',
  clientName: '',
  format,
  records: 1,
});

describe('what is exported', () => {
  it('is named after the recording, and after its topic when it is the only one', () => {
    const request = { topics: ['/lab/a'], span: undefined, name: 'Study: 7' } as const;
    expect(exportName({ ...request, format: 'csv' }, 'webm')).toBe('Study- 7 lab-a.csv');
    expect(exportName({ ...request, format: 'video' }, 'mp4')).toBe('Study- 7 lab-a.mp4');
    expect(exportName({ ...request, format: 'xdf' }, 'webm')).toBe('Study- 7.xdf');
    expect(exportName({ ...request, format: 'csv', topics: ['/a', '/b'] }, 'webm')).toBe(
      'Study- 7 CSV.zip',
    );
  });

  it('[PD-19] is named after neither recording nor topic where personal data is replaced', () => {
    const personal = { rules: { ...SHARING_RULES, notes: 'keep' as const }, key: undefined };
    const request = { topics: ['/lab/ada'], span: undefined, name: 'Ada', personal } as const;
    expect(exportName({ ...request, format: 'csv' }, 'webm')).toBe('Shared recording.csv');
    expect(exportName({ ...request, format: 'mcap' }, 'webm')).toBe('Shared recording.mcap');
    expect(exportName({ ...request, format: 'csv', topics: ['/a', '/ada'] }, 'webm')).toBe(
      'Shared recording CSV.zip',
    );
  });

  it('has files of different names, also where upper and lower case are the same', () => {
    expect(topicFileNames(['/a/b', '/a-b', '/A/B', '/'], 'csv')).toEqual([
      ...['a-b.csv', 'a-b 2.csv', 'A-B 3.csv', 'topic.csv'],
    ]);
  });

  it('is bit for bit as recorded only where no personal data is replaced', () => {
    expect(formatHint('mcap', false)).toMatch('bit for bit');
    expect(formatHint('mcap', true)).toBe(
      'A recording of its own, with sessions, clocks and markers.',
    );
  });

  it('has messages of other programs as MCAP only, and as video only topics with images', () => {
    const topics = [topic('/n', 'double'), topic('/c', 'image2D'), topic('/f', 'sensor_msgs/Imu')];
    const names = (format: 'csv' | 'video' | 'mcap') =>
      exportableTopics(topics, format, 1000).map((one) => one.topic);
    expect(names('csv')).toEqual(['/n', '/c']);
    expect(names('video')).toEqual(['/c']);
    expect(names('mcap')).toContain('/f');
  });

  it('names clients and counts as the timeline does', () => {
    const id = '2fb1c6a2-9d0f-4c8e-8a3b-0f6f3c2e9d11';
    const stick = { ...topic(`/${id}/stick`, 'vector2'), records: 30_563 };
    const names = new Map([[id, 'Mara']]);
    const [track] = exportableTopics([stick], 'csv', 1000, names);
    expect(topicOption(track!)).toMatchObject({
      text: 'stick · Mara',
      detail: 'vector2, 30\u00a0563 records',
    });
  });

  it('says why a format is not available', () => {
    const pictures = exportableTopics([topic('/c', 'image2D')], 'video', 1000);
    expect(formatRefusal('video', [], true)).toBe('The recording has no topic with images.');
    expect(formatRefusal('video', pictures, false)).toContain('This browser cannot encode video');
    expect(formatRefusal('video', pictures, true)).toBeUndefined();
  });

  it('has videos with even sides, at most 1920 pixels', () => {
    expect(evenSize({ width: 641, height: 479 })).toEqual({ width: 642, height: 480 });
    expect(evenSize({ width: 3840, height: 2161 })).toEqual({ width: 1920, height: 1080 });
    expect(evenSize({ width: 1, height: 1 })).toEqual({ width: 2, height: 2 });
  });
});
