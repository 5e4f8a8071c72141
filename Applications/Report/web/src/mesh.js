/**
 * The mesh of a page: cells, their faces, and which of them are seen.
 * Coordinates are LPS millimetres; cells and nodes are numbered in lattice order.
 */

/** Faces of a hexahedron in VTK's order, as corners. */
const facesOfCell = [
  [0, 4, 7, 3],
  [1, 2, 6, 5],
  [0, 1, 5, 4],
  [3, 7, 6, 2],
  [0, 3, 2, 1],
  [4, 5, 6, 7],
];

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let at = 0; at < text.length; ++at) {
    bytes[at] = text.charCodeAt(at);
  }
  return new DataView(bytes.buffer);
}

function numbersOf(base64, size) {
  const view = bytesOf(base64);
  const numbers = size === 2 ? new Uint16Array(view.byteLength / 2) : new Uint32Array(view.byteLength / 4);
  for (let at = 0; at < numbers.length; ++at) {
    numbers[at] = size === 2 ? view.getUint16(2 * at, true) : view.getUint32(4 * at, true);
  }
  return numbers;
}

function latticeCells(n, count) {
  const nodes = new Uint32Array(8 * count);
  const index = new Uint16Array(3 * count);
  const node = (i, j, k) => i + n * (j + n * k);
  let cell = 0;
  for (let k = 0; k < n - 1; ++k) {
    for (let j = 0; j < n - 1; ++j) {
      for (let i = 0; i < n - 1; ++i, ++cell) {
        index.set([i, j, k], 3 * cell);
        const corners = [node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k)];
        nodes.set([...corners, ...corners.map((corner) => corner + n * n)], 8 * cell);
      }
    }
  }
  return { nodes, index, end: cell };
}

/**
 * Every face once: its four nodes, its first cell and its second, -1 where there is none.
 * A face is known by the diagonal at its smallest node, which no other face of a mesh has.
 */
function facesOf(cellNodes, cells, nodeCount) {
  const corners = new Uint32Array(4 * 6 * cells);
  const neighbours = new Int32Array(2 * 6 * cells);
  const known = new Map();
  let count = 0;
  for (let cell = 0; cell < cells; ++cell) {
    for (const local of facesOfCell) {
      const [a, b, c, d] = local.map((corner) => cellNodes[8 * cell + corner]);
      const least = Math.min(a, b, c, d);
      const opposite = least === a ? c : least === c ? a : least === b ? d : b;
      const key = least * nodeCount + opposite;
      const face = known.get(key);
      if (face === undefined) {
        known.set(key, count);
        corners.set([a, b, c, d], 4 * count);
        neighbours[2 * count] = cell;
        neighbours[2 * count + 1] = -1;
        ++count;
      } else {
        neighbours[2 * face + 1] = cell;
      }
    }
  }
  return { count, corners, neighbours };
}

export class Mesh {
  /** @param {object} data  as MeshData.h describes */
  constructor(data) {
    const n = data.nodesPerSide;
    const rounded = numbersOf(data.positions.data, 2);
    this.positions = Float32Array.from(
      rounded,
      (number, at) => data.positions.low[at % 3] + data.positions.step[at % 3] * number,
    );
    this.cells = data.cells;
    const lattice = latticeCells(n, data.cells);
    this.cellIndex = lattice.index;
    if (data.padding) {
      lattice.nodes.set(numbersOf(data.padding.nodes, 4), 8 * lattice.end);
      lattice.index.set(numbersOf(data.padding.index, 2), 3 * lattice.end);
    }
    this.fields = data.fields.map((field) => ({
      ...field,
      values: Float32Array.from(numbersOf(field.values.data, 2), (v) => field.values.low + field.values.step * v),
    }));
    this.faces = facesOf(lattice.nodes, data.cells, this.positions.length / 3);
  }

  /** @param {string} id */
  field(id) {
    return this.fields.find((field) => field.id === id);
  }

  /**
   * @param {{low: number[], high: number[], shells: number[]}} range  cells from low to high along i, j, k, from 0; and
   *        shells from the first to the second
   * @returns {Uint8Array} 1 for each cell that is seen
   */
  seenCells({ low, high, shells }) {
    const shell = this.field("shell").values;
    const seen = new Uint8Array(this.cells);
    for (let cell = 0; cell < this.cells; ++cell) {
      let isSeen = Math.round(shell[cell]) >= shells[0] && Math.round(shell[cell]) <= shells[1];
      for (let axis = 0; axis < 3; ++axis) {
        const at = this.cellIndex[3 * cell + axis];
        isSeen = isSeen && at >= low[axis] && at <= high[axis];
      }
      seen[cell] = isSeen ? 1 : 0;
    }
    return seen;
  }

  /** The faces between a cell that is seen and none, each with the cell that is seen. @param {Uint8Array} seen */
  *seenFaces(seen) {
    const { count, corners, neighbours } = this.faces;
    for (let face = 0; face < count; ++face) {
      const [first, second] = [neighbours[2 * face], neighbours[2 * face + 1]];
      const seesSecond = second >= 0 && seen[second] === 1;
      if ((seen[first] === 1) !== seesSecond) {
        yield { corners: corners.subarray(4 * face, 4 * face + 4), cell: seesSecond ? second : first };
      }
    }
  }
}
