import { settle } from '@ubii/timing/testing';
import { describe, expect, it, vi } from 'vitest';
import { Listeners } from './listeners.ts';

const unexpected = (error: unknown): never => {
  throw error;
};

describe('Listeners', () => {
  it('calls each callback in the order they were added', () => {
    const listeners = new Listeners<number>(unexpected);
    const calls: string[] = [];
    listeners.add((n) => calls.push(`a${n}`));
    listeners.add((n) => calls.push(`b${n}`));
    listeners.emit(1);
    expect(calls).toEqual(['a1', 'b1']);
  });

  it('takes back one of two equal callbacks', () => {
    const listeners = new Listeners<number>(unexpected);
    const callback = vi.fn();
    const remove = listeners.add(callback);
    listeners.add(callback);
    remove();
    remove();
    listeners.emit(1);
    expect(callback).toHaveBeenCalledOnce();
  });

  it('lets a callback remove itself and others while being called', () => {
    const listeners = new Listeners<number>(unexpected);
    const second = vi.fn();
    const removeFirst = listeners.add(() => {
      removeFirst();
      removeSecond();
    });
    const removeSecond = listeners.add(second);
    listeners.emit(1);
    listeners.emit(2);
    expect(second).toHaveBeenCalledOnce();
  });

  it('calls the others when one throws or rejects, and reports the errors', async () => {
    const onError = vi.fn();
    const listeners = new Listeners<number>(onError);
    const last = vi.fn();
    listeners.add(() => {
      throw new Error('thrown');
    });
    listeners.add((): unknown => Promise.reject(new Error('rejected')));
    listeners.add(last);
    listeners.emit(1);
    expect(last).toHaveBeenCalledOnce();
    await settle();
    expect(onError.mock.calls).toEqual([
      [new Error('thrown'), 'listener'],
      [new Error('rejected'), 'listener'],
    ]);
  });
});
