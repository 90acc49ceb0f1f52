// The values after a PLY header, one after another, whether they are text or binary of either byte order.
import { TextScanner } from '../text/text-scanner.js';
import { PLY_TYPE_SIZES, type PlyHeader, type PlyType } from './ply-header.js';

export interface PlyValues {
  /** @throws Error at the end of the file. Text that is no number is NaN. */
  next(type: PlyType): number;
  /** As `next`. @throws Error that quotes text which is no number. */
  required(type: PlyType): number;
}

export function plyValues(bytes: Uint8Array<ArrayBuffer>, { encoding, end }: PlyHeader): PlyValues {
  return encoding === 'text'
    ? textValues(bytes, end)
    : binaryValues(bytes, end, encoding === 'little-endian');
}

const truncated = (): Error => new Error('it is truncated: it ends before its last value');

function textValues(bytes: Uint8Array, start: number): PlyValues {
  const scanner = new TextScanner(bytes, start);
  return {
    next: () => {
      if (!scanner.nextWord()) throw truncated();
      return scanner.number();
    },
    required: () => {
      if (!scanner.nextWord()) throw truncated();
      return scanner.requiredNumber();
    },
  };
}

function binaryValues(bytes: Uint8Array<ArrayBuffer>, start: number, little: boolean): PlyValues {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = start;
  const next = (type: PlyType): number => {
    const from = at;
    at += PLY_TYPE_SIZES[type];
    if (at > view.byteLength) throw truncated();
    switch (type) {
      case 'int8':
        return view.getInt8(from);
      case 'uint8':
        return view.getUint8(from);
      case 'int16':
        return view.getInt16(from, little);
      case 'uint16':
        return view.getUint16(from, little);
      case 'int32':
        return view.getInt32(from, little);
      case 'uint32':
        return view.getUint32(from, little);
      case 'float32':
        return view.getFloat32(from, little);
      case 'float64':
        return view.getFloat64(from, little);
    }
  };
  return { next, required: next };
}
