import { describe, expect, it, vi } from 'vitest';
import { RecordBuffer } from './record-buffer.ts';

function setup(capacity = 3) {
  const handleReturn = vi.fn();
  return { buffer: new RecordBuffer<number>(capacity, handleReturn), handleReturn };
}

async function takeAll(buffer: RecordBuffer<number>): Promise<number[]> {
  const taken: number[] = [];
  for (let r = await buffer.next(); r.done !== true; r = await buffer.next()) taken.push(r.value);
  return taken;
}

describe('RecordBuffer', () => {
  it('gives what came before and what comes while waiting, in order', async () => {
    const { buffer } = setup();
    buffer.push(1);
    const first = buffer.next();
    const second = buffer.next();
    buffer.push(2);
    expect(await first).toEqual({ done: false, value: 1 });
    expect(await second).toEqual({ done: false, value: 2 });
  });

  it('drops and counts the oldest over its capacity', async () => {
    const { buffer } = setup(3);
    for (const n of [1, 2, 3, 4, 5]) buffer.push(n);
    buffer.end(undefined);
    expect(await takeAll(buffer)).toEqual([3, 4, 5]);
    expect(buffer.dropped).toBe(2);
  });

  it('stays in order through many records', async () => {
    const { buffer } = setup(5_000);
    const numbers = Array.from({ length: 4_000 }, (_, i) => i);
    for (const n of numbers) buffer.push(n);
    buffer.end(undefined);
    expect(await takeAll(buffer)).toEqual(numbers);
  });

  it('gives what it holds before it ends', async () => {
    const { buffer } = setup();
    buffer.push(1);
    buffer.end(undefined);
    buffer.push(2);
    expect(await takeAll(buffer)).toEqual([1]);
  });

  it('throws the error of its end once, after what it holds', async () => {
    const { buffer } = setup();
    buffer.push(1);
    buffer.end(new Error('superseded'));
    expect(await buffer.next()).toEqual({ done: false, value: 1 });
    await expect(buffer.next()).rejects.toThrow('superseded');
    expect(await buffer.next()).toEqual({ done: true, value: undefined });
  });

  it('settles those who wait when it ends', async () => {
    const { buffer } = setup();
    const first = buffer.next();
    const second = buffer.next();
    buffer.end(undefined);
    expect((await first).done).toBe(true);
    expect((await second).done).toBe(true);
  });

  it('is done, and says so, when the consumer leaves', async () => {
    const { buffer, handleReturn } = setup();
    buffer.push(1);
    await buffer.return();
    buffer.push(2);
    expect((await buffer.next()).done).toBe(true);
    expect(handleReturn).toHaveBeenCalledOnce();
  });
});
