// Recognises exceptions that say that memory could not be allocated.

/**
 * Browsers throw a RangeError for that, Firefox also an InternalError or a string. A RangeError can also mean an offset
 * outside a buffer or a recursion that is too deep.
 */
export function isOutOfMemory(error: unknown): boolean {
  const text = String(error);
  if (error instanceof RangeError) return !/offset|bounds|multiple|call stack|recursion/i.test(text);
  return /out of memory|allocation size/i.test(text);
}
